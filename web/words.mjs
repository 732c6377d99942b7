// Every word of the page, in both languages.
export const WORDS = {
  en: {
    other: "한국어", title: "lab", loading: "Loading Python …", ready: "Drag the cloth to aim, a ball to move it.",
    purpose: "The exact billiard engine, in your browser. Change a number, see the whole shot at once.",
    setup: "Set-up", law: "Cushion", play: "▶ Play", pause: "❚❚ Pause", again: "Start again", link: "Copy link", copied: "Link copied.",
    log: "What happens", rest: "Where the balls rest, m: every digit", code: "The same shot in Python, with the same digits",
    digits: "Alike on every machine; their hash:", graph: "Speed of each ball, m/s, against time, s",
    heads: ["time, s", "event", "what", "closing, m/s"], gone: "in a pocket", rests: "all rest after", failed: "Python did not load:",
    setups: { carom: "Four balls", "three-cushion": "Three-cushion", break: "8-ball: break" },
    laws: { table: "the table's", rigid: "rigid (Han)", mathavan: "Mathavan", thesis: "thesis" },
    events: { roll: "rolls", ball: "hits", cushion: "cushion", rest: "rests", pocket: "pocketed", land: "comes down", off: "leaves", slow: "slower" },
    names: {},
    numbers: {
      speed: ["Speed", "m/s"], angle: ["Angle", "°, anticlockwise from the right"], follow: ["Follow, draw", "m/s of spin: + runs on, − draws back"],
      masse: ["Massé", "m/s of spin: + curves right, − left"], side: ["Side", "m/s of spin: + right english, − left"],
    },
  },
  ko: {
    other: "English", title: "실험실", loading: "파이썬을 불러오는 중 …", ready: "천을 끌면 조준, 공을 끌면 이동합니다.",
    purpose: "브라우저에서 도는 정확한 당구 엔진. 숫자를 바꾸면 샷 전체가 바로 보입니다.",
    setup: "배치", law: "쿠션 법칙", play: "▶ 재생", pause: "❚❚ 멈춤", again: "처음부터", link: "링크 복사", copied: "링크를 복사했습니다.",
    log: "일어나는 일", rest: "공이 멈추는 곳, m: 모든 자릿수", code: "같은 샷을 파이썬으로, 같은 자릿수까지",
    digits: "어느 컴퓨터에서나 같습니다. 해시:", graph: "시간(s)에 따른 공의 속력(m/s)",
    heads: ["시간, s", "사건", "대상", "접근 속력, m/s"], gone: "포켓에 들어감", rests: "모두 멈춤:", failed: "파이썬을 불러오지 못했습니다:",
    setups: { carom: "4구", "three-cushion": "3쿠션", break: "8볼 브레이크" },
    laws: { table: "당구대의 것", rigid: "강체 (Han)", mathavan: "Mathavan", thesis: "논문" },
    events: { roll: "구름", ball: "충돌", cushion: "쿠션", rest: "멈춤", pocket: "포켓", land: "착지", off: "이탈", slow: "감속" },
    names: {
      white: "흰 공", yellow: "노란 공", red: "빨간 공", "red 2": "빨간 공 2", cue: "수구",
      north: "위쪽", south: "아래쪽", east: "오른쪽", west: "왼쪽",
    },
    numbers: {
      speed: ["속도", "m/s"], angle: ["각도", "°, 오른쪽에서 반시계 방향"], follow: ["앞뒤 회전", "m/s: + 밀어치기, − 끌어치기"],
      masse: ["찍어치기", "m/s: + 오른쪽으로, − 왼쪽으로 휨"], side: ["좌우 회전", "m/s: + 오른쪽 당점, − 왼쪽 당점"],
    },
  },
};
