"""Korean: a shot from a drawn path, and a table from tracks."""

WORDS = {
    "key.sketch": "수구 경로 그리기",
    "help.sketch": "경로를 그려 샷 찾기",
    "hint.sketch": "수구의 경로를 그리세요 · Esc 끝내기",
    "notice.sketch.start": "경로는 수구에서 시작하세요",
    "notice.sketch.short": "경로가 너무 짧습니다",
    "notice.sketch.searching": "샷을 찾는 중 … · Esc 중지",
    "notice.sketch.cancelled": "찾기를 멈췄습니다",
    "notice.sketch.none": "그런 샷이 없습니다: 최소 {0} cm 차이",
    "notice.sketch.failed": "이 경로의 샷을 찾을 수 없습니다",
    "notice.sketch.found": "오차 {0} cm · V ±{1} ±{2}° · 회전 ±{3}",
    "notice.sketch.partly": "{4} %까지, 오차 {0} cm · V ±{1} ±{2}°",
}
