"""Korean: labs, graphs of a shot, laws compared, a shot as data."""

WORDS = {
    "key.sheet labs": "실험: 문제와 답",
    "labs.title": "실험",
    "labs.hint": "Enter 장면 열기 · Tab 답 쓰기 · PgUp PgDn 다른 숫자 · P 인쇄할 쪽 · Esc 닫기",
    "labs.open": "장면 열기",
    "labs.check": "확인",
    "labs.print": "인쇄할 쪽",
    "labs.usual": "기본 숫자",
    "labs.seed": "숫자 {seed}번",
    "labs.right": "맞음",
    "labs.large": "너무 큼",
    "labs.small": "너무 작음",
    "labs.checked": "{1}개 가운데 {0}개가 맞았습니다",
    "labs.unanswered": "답을 먼저 쓰십시오",
    "labs.unread": "“{word}”은(는) 숫자가 아닙니다",
    "labs.printed": "{word}에 썼습니다",
    "labs.unprinted": "쪽을 쓸 수 없습니다: {word}",
}
