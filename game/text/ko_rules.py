"""Korean: the rules of pool, snooker, pyramid and the other games of carom."""

POOL_FOULS = (
    "파울: 수구가 빠지거나 밖으로 나감, 다른 공을 먼저 맞힘, 공을 못 맞힘, 첫 공을 맞힌 뒤 "
    "아무 공도 쿠션에 닿거나 포켓에 들어가지 않음."
)
CAROM_POINT = "나머지 두 공을 모두 맞히면 1점, 실패할 때까지 계속 칩니다."
BALKLINE = (
    "선이 당구대를 구역으로 나눕니다. 두 적구가 한 구역(또는 쿠션 앞 앵커)에 있는 동안 "
    "{n} 점수가 됩니다."
)
ONE, TWO = "한 번만", "연속 두 번까지"
OUT = "그다음 샷은 공 하나를 밖으로 내보내야 하고, 돌아오면 새로 셉니다."
WORDS = {
    "rule.one-cushion.1": "두 번째 공 전에 쿠션을 한 번 이상 맞히고 두 공을 모두 맞히면 1점입니다.",
    "rule.one-cushion.2": "초구는 빨간 공을 먼저 맞혀야 합니다(선택).",
    "rule.one-cushion.3": "공이 밖으로 나가면 파울, 모든 공을 초구 자리에 놓습니다.",
    "rule.straight-rail.1": CAROM_POINT,
    "rule.straight-rail.2": "네 구석의 삼각형 안에 두 적구가 있으면 연속 두 번까지 점수가 됩니다.",
    "rule.straight-rail.3": OUT,
    "rule.balkline-47/1.1": CAROM_POINT,
    "rule.balkline-47/1.2": BALKLINE.format(n=ONE),
    "rule.balkline-47/1.3": OUT,
    "rule.balkline-47/2.1": CAROM_POINT,
    "rule.balkline-47/2.2": BALKLINE.format(n=TWO),
    "rule.balkline-47/2.3": OUT,
    "rule.balkline-71/2.1": CAROM_POINT,
    "rule.balkline-71/2.2": BALKLINE.format(n=TWO),
    "rule.balkline-71/2.3": OUT,
    "rule.8-ball.1": "자기 그룹(단색 또는 줄무늬) 일곱 개를 넣고 8번을 넣으면 이깁니다.",
    "rule.8-ball.2": (
        "브레이크 뒤 처음 콜대로 넣은 공이 그룹을 정합니다. 공(@[ball 1])과 포켓(@[pocket 1])을 "
        "콜하고, 콜이 없으면 먼저 맞은 공으로 봅니다."
    ),
    "rule.8-ball.3": POOL_FOULS,
    "rule.8-ball.4": "파울 뒤에는 상대가 수구를 아무 데나 놓습니다(프리볼).",
    "rule.8-ball.5": "8번을 일찍, 콜하지 않은 포켓에, 또는 파울과 함께 넣으면 집니다.",
    "rule.8-ball.6": "브레이크는 공을 넣거나 네 개를 쿠션에 보내야 합니다. 아니면 상대가 고릅니다.",
    "rule.9-ball.1": "가장 낮은 번호를 먼저 맞히고, 어떻게든 9번을 넣으면 이깁니다.",
    "rule.9-ball.2": POOL_FOULS,
    "rule.9-ball.3": "파울 뒤에는 상대가 수구를 아무 데나 놓습니다(프리볼).",
    "rule.9-ball.4": (
        "브레이크 바로 다음에는 푸시아웃(@[call push])을 할 수 있고, 누가 칠지 상대가 고릅니다."
    ),
    "rule.9-ball.5": "세 번 연속 파울이면 랙을 집니다. 두 번째에 경고합니다.",
    "rule.10-ball.1": "가장 낮은 번호를 먼저 맞히고, 모든 공을 콜합니다.",
    "rule.10-ball.2": "10번은 마지막에 넣어야 이깁니다. 일찍 들어가면 스폿에 놓습니다(선택).",
    "rule.10-ball.3": POOL_FOULS,
    "rule.10-ball.4": "푸시아웃(@[call push])과 3연속 파울은 9볼과 같습니다.",
    "rule.10-ball.5": "콜하지 않은 공이 들어가면 누가 칠지 상대가 고릅니다.",
    "rule.14.1.1": "콜대로 넣은 공마다 1점, 목표 점수에 먼저 도달하면 이깁니다.",
    "rule.14.1.2": "공이 하나 남으면 나머지 열네 개를 맨 앞자리 없이 다시 랙합니다.",
    "rule.14.1.3": (
        "파울은 1점 감점, 3연속이면 15점 더 감점입니다. 첫 브레이크는 두 공과 수구를 쿠션에 "
        "보내야 하고, 아니면 2점 감점입니다."
    ),
    "rule.14.1.4": "세이프티(@[call safety])를 콜하면 넣지 않고 차례를 넘깁니다.",
    "rule.snooker.1": "빨간 공과 색 공을 번갈아 넣고, 빨간 공이 남은 동안 색 공은 제자리로 갑니다.",
    "rule.snooker.2": (
        "빨강 1, 노랑 2, 초록 3, 갈색 4, 파랑 5, 분홍 6, 검정 7점. 색은 @[ball 1]로 지정하고, "
        "지정이 없으면 먼저 맞은 공입니다."
    ),
    "rule.snooker.3": "마지막에는 색 공을 이 순서로 넣고, 넣은 공은 나오지 않습니다.",
    "rule.snooker.4": "파울이면 상대가 칠 공이나 관련된 공의 점수를, 적어도 4점을 얻습니다.",
    "rule.snooker.5": (
        "파울 뒤 상대는 치거나, 다시 치게 하거나, 미스라면 되풀이하게 합니다. 칠 공의 양쪽 "
        "끝을 모두 맞힐 수 없으면 프리볼입니다."
    ),
    "rule.free-pyramid.1": "아무 공이나 칠 수 있고, 여덟 개를 넣으면 이깁니다.",
    "rule.free-pyramid.2": "칠 공은 @[ball 1]로 고르고, 그 공이 들어가도 점수입니다.",
    "rule.free-pyramid.3": "공을 넣거나, 적어도 하나를 쿠션에 보내야 합니다.",
    "rule.free-pyramid.4": "파울의 값은 메뉴에서 고릅니다.",
    "rule.dynamic-pyramid.1": "수구만 치고, 여덟 개를 넣으면 이깁니다.",
    "rule.dynamic-pyramid.2": (
        "수구가 다른 공을 맞고 들어가면 점수입니다. 공 하나를 빼고 수구를 아무 데나 놓습니다."
    ),
    "rule.dynamic-pyramid.3": "공을 넣거나, 적어도 하나를 쿠션에 보내야 합니다.",
    "rule.combined-pyramid.1": "수구만 치고, 여덟 개를 넣으면 이깁니다.",
    "rule.combined-pyramid.2": (
        "수구가 다른 공을 맞고 들어가면 점수입니다. 공 하나를 빼고 수구를 하우스에 놓습니다."
    ),
    "rule.combined-pyramid.3": "공을 넣거나, 적어도 하나를 쿠션에 보내야 합니다.",
}
