"""Korean: a shot from a drawn path, and a table from tracks."""

WORDS = {
    "key.sketch": "수구 경로 그리기",
    "help.sketch": "경로를 그려 샷 찾기 · 길 보기",
    "hint.sketch": "수구의 경로를 그리세요 · Esc 끝내기",
    "notice.sketch.start": "경로는 수구에서 시작하세요",
    "notice.sketch.short": "경로가 너무 짧습니다",
    "notice.sketch.searching": "샷을 찾는 중 … · Esc 중지",
    "notice.sketch.cancelled": "찾기를 멈췄습니다",
    "notice.sketch.none": "그런 샷이 없습니다: 최소 {0} cm 차이",
    "notice.sketch.failed": "이 경로의 샷을 찾을 수 없습니다",
    "notice.sketch.found": "오차 {0} cm · V ±{1} ±{2}° · 회전 ±{3}",
    "notice.sketch.partly": "{4} %까지, 오차 {0} cm · V ±{1} ±{2}°",
    "key.sheet tracks": "내 당구대, 궤적에서",
    "table.own": "내 당구대",
    "tracks.title": "내 당구대",
    "tracks.hint": "Enter 맞추기 · ↑ ↓ 파일 · PgUp PgDn 시작할 당구대 · Esc 닫기",
    "tracks.hint.running": "Enter나 Esc 중지 · 그동안 이 페이지를 닫아도 됩니다",
    "tracks.folder": "궤적 폴더: {folder}",
    "tracks.box": "궤적 파일(.csv)이나 당구대 파일(.json)의 경로를 입력하거나 붙여 넣으세요",
    "tracks.files": "“tracks” 폴더의 파일",
    "tracks.nofiles": "“tracks” 폴더가 비어 있습니다",
    "tracks.base": "시작: {table}",
    "tracks.fit": "맞추기",
    "tracks.stop": "중지",
    "tracks.save": "내 당구대로 저장",
    "tracks.play": "내 당구대에서 치기",
    "tracks.about": (
        "궤적 파일의 첫 줄은 이름입니다: track, time, white x, white y, yellow x, … 그다음 "
        "카메라 영상 한 장마다 한 줄씩, 시간은 초, 위치는 당구대 중심에서 미터로 적습니다. "
        "보이지 않은 공은 빈칸으로 둡니다."
    ),
    "tracks.about.2": (
        "공이 이 궤적을 따라 구르게 하는 천의 마찰과 쿠션의 반발을 찾습니다. "
        "잘 구별하려면 스트로크가 네 개 이상 필요합니다."
    ),
    "tracks.own": "저장된 내 당구대가 있습니다. 게임 메뉴에도 있습니다.",
    "tracks.noown": "저장된 내 당구대가 아직 없습니다.",
    "tracks.running": "맞추는 중 … {seconds}초",
    "tracks.looking": "궤적 {count}개, 찾는 값: {names}",
    "tracks.misfit": "궤적 {count}개, 오차 {misfit} mm",
    "tracks.before": "이전",
    "tracks.found": "찾은 값",
    "tracks.cloth.slide": "미끄럼 마찰",
    "tracks.cloth.roll": "구름 저항",
    "tracks.cushion.e": "쿠션 반발",
    "tracks.cushion.mu": "쿠션 마찰",
    "tracks.unseen": "이 궤적으로는 알 수 없어 그대로 둔 값: {name}",
    "tracks.fitted": "찾았습니다 · Enter 내 당구대로 저장",
    "tracks.loaded": "당구대를 읽었습니다 · Enter 내 당구대로 저장",
    "tracks.saved": "저장했습니다 · Enter 여기서 치기",
    "tracks.unsaved": "저장할 수 없습니다",
    "tracks.stopped": "중지했습니다",
    "tracks.none": "파일을 고르거나 경로를 입력하세요",
    "tracks.unfit": "경로가 너무 깁니다",
    "tracks.failed": "아무것도 찾지 못했습니다",
    "tracks.broken": "저장된 당구대를 읽을 수 없습니다. 다시 저장하면 .broken으로 보관합니다",
}
