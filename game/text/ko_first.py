"""Korean: the first minute, drills, diamonds, and shots that are kept and shared."""

WORDS = {
    "event.of.strike": "{ball} {said}",
    "event.of.cushion": "{ball} → {said}",
    "event.of.rest": "{ball} {said}",
    "launch.speed": "공 출발 속도",
    "launch.spin": "회전",
    "launch.squirt": "스쿼트",
    "launch.rise": "튀는 각도",
    "launch.left": "왼쪽",
    "launch.right": "오른쪽",
    "unit.spin": "회/s",
    "key.full": "전체 화면, 창",
    "hall.points": "{points}점",
    "hall.handicap": "수지 {hall}",
    "menu.hint.hall": "{points}점 = 당구장 수지 {hall} · ← → 1점씩, PgUp PgDn 10점씩",
}
