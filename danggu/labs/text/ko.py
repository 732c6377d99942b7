"""실험이 한국어로 하는 말: what labs say in Korean."""

TEXT = {
    # -- five-sevenths --
    "five-sevenths.title": "5/7 법칙",
    "five-sevenths.ask": (
        "공의 가운데를 쳐서 회전 없이 {speed:g} m/s로 출발시킵니다. 공은 처음에 미끄러집니다."
        " 천의 마찰은 공을 늦추는 동시에 돌게 하고, 마침내 공은 구르기 시작합니다. 표는"
        " 여러 시각에서 잰 속력입니다.\n\n"
        "속력을 시간에 대해 그리고, 직선이 꺾이는 시각을 찾으십시오. 그때부터 공은 구릅니다."
        " 속력은 몇 배가 되었습니까? 회전 에너지를 포함한 운동 에너지 가운데 얼마를 잃었습니까?"
        " 기울기에서 천의 마찰 계수를 구하십시오(g = 9.81 m/s²).\n\n"
        "더 생각해 봅시다. 뒤로 도는 회전(끌어치기)을 주면 구르는 속력이 더 작아집니다. 회전(공"
        " 표면의 속력)이 얼마이면 공이 구르지 않고 그 자리에 멈추겠습니까? 직접 쳐 보십시오."
    ),
    "five-sevenths.speed": "구르기 시작할 때의 속력",
    "five-sevenths.time": "구를 때까지 걸린 시간",
    "five-sevenths.length": "구를 때까지 간 거리",
    "five-sevenths.friction": "천의 마찰 계수 μ",
    "five-sevenths.lost": "잃은 에너지의 비율",
    "five-sevenths.draw": "공이 멈추는 끌어치기 회전의 크기(양수)",
    # -- right-angle --
    "right-angle.title": "90° 법칙과 반발 계수",
    "right-angle.ask": (
        "흰 공이 {speed:g} m/s로 출발해, 서 있는 빨간 공에 맞습니다. 끌어치기 회전이 막 사라진"
        " 순간이라 흰 공은 돌지 않고 미끄러집니다. 두 중심을 잇는 선은 흰 공의 길과 {cut:g}°를"
        " 이룹니다. 두 공의 질량은 같고, 공 사이의 마찰은 없다고 봅니다.\n\n"
        "에너지를 잃지 않는다면 두 공은 직각으로 갈라집니다. 왜 그렇습니까? 여기서는 중심선"
        " 방향으로 조금 잃습니다. 충돌 직후 두 길 사이의 각과 두 속력을 표에서 계산하고,"
        " 그림에서도 각을 재어 보십시오.\n\n"
        "빨간 공은 중심선을 따라 나갑니다. 충돌 전후 흰 공의 속도에서 그 방향의 성분을 찾아"
        " 반발 계수 e를 구하십시오."
    ),
    "right-angle.angle": "두 길 사이의 각",
    "right-angle.white": "충돌 뒤 흰 공의 속력",
    "right-angle.red": "충돌 뒤 빨간 공의 속력",
    "right-angle.e": "반발 계수 e",
    # -- thirty-degrees --
    "thirty-degrees.title": "30° 법칙",
    "thirty-degrees.ask": (
        "흰 공이 x축을 따라 {speed:g} m/s로 구르다가 빨간 공에 {cut:g}°로 맞습니다(중심선이"
        " 길과 이루는 각). 충돌에서 잃는 것은 없습니다. 충돌 직후 흰 공은 빨간 공과 직각"
        " 방향으로 미끄러지지만, 구르던 회전을 그대로 가지고 있어서 다시 구를 때까지 길이"
        " 앞으로 휩니다.\n\n"
        "흰 공이 충돌 직후에 꺾인 각과 마지막에 꺾인 각을 구하십시오. 당구에서는 너무 얇거나"
        " 두껍지 않으면 약 30°라고 합니다.\n\n"
        "맞는 각을 바꾸어 가며(게임에서, 또는 다른 번호로) 가장 크게 꺾이는 각을 찾으십시오."
    ),
    "thirty-degrees.red": "빨간 공의 방향(x축에서)",
    "thirty-degrees.first": "충돌 직후 흰 공이 꺾인 각",
    "thirty-degrees.last": "다시 구를 때 흰 공이 꺾인 각",
    "thirty-degrees.greatest": "가장 크게 꺾이는 각",
    # -- momentum-energy --
    "momentum-energy.title": "충돌의 운동량과 에너지",
    "momentum-energy.ask": (
        "흰 공({white_mass:g} kg)과 빨간 공({red_mass:g} kg)이 서로를 향해 미끄러지다가"
        " 부딪칩니다. 표는 충돌 직전과 직후의 속도입니다.\n\n"
        "공마다 운동량 p = m v의 x, y 성분과 그 합을 충돌 전후로 구하십시오. 두 방향 모두에서"
        " 운동량이 보존됩니까? 병진 운동 에너지 m v²/2도 같은 방법으로 구하십시오. 얼마가,"
        " 어디로 사라졌습니까?\n\n"
        "충격량은 두 중심을 잇는 방향입니다. 한 공의 운동량 변화에서 그 방향을 찾고, 그"
        " 방향으로 멀어지는 속력과 다가오던 속력의 비인 반발 계수 e를 구하십시오."
    ),
    "momentum-energy.px": "운동량 합의 x 성분",
    "momentum-energy.py": "운동량 합의 y 성분",
    "momentum-energy.before": "충돌 전 운동 에너지의 합",
    "momentum-energy.after": "충돌 뒤 운동 에너지의 합",
    "momentum-energy.e": "반발 계수 e",
    # -- unknown-mass --
    "unknown-mass.title": "모르는 질량",
    "unknown-mass.ask": (
        "흰 공의 질량은 {known:g} kg이고 {speed:g} m/s로 출발합니다. 크기가 같은 빨간 공이 서"
        " 있는데, 질량을 모릅니다. 중심선은 흰 공의 길과 {cut:g}°를 이룹니다.\n\n"
        "표의 속도에서 빨간 공의 질량을 구하십시오. x 성분과 y 성분이 각각 답을 줍니다. 두 답이"
        " 같습니까? 측정 오차의 영향을 덜 받는 쪽은 어느 쪽입니까?\n\n"
        "반발 계수 e와, 잃은 병진 운동 에너지의 비율도 구하십시오."
    ),
    "unknown-mass.mass": "빨간 공의 질량",
    "unknown-mass.e": "반발 계수 e",
    "unknown-mass.lost": "잃은 에너지의 비율",
    # -- cushion-side --
    "cushion-side.title": "좌우 회전과 쿠션에서 나오는 각",
    "cushion-side.ask": (
        "공이 {speed:g} m/s로 오른쪽 쿠션을 향해 구릅니다. 쿠션에 수직인 선과 {angle:g}°를"
        " 이룹니다. 회전 없이, 오른쪽 회전 {side:g} m/s(공 표면의 속력)를 주고, 그리고 같은"
        " 크기의 왼쪽 회전을 주고 한 번씩 칩니다.\n\n"
        "표는 다섯 가지 회전에 대한 쿠션 직전과 직후의 속도입니다. 쿠션에 수직인 선에서 잰"
        " 나오는 각을 구하십시오. 쿠션을 따라 계속 나아가면 양수, 되돌아오면 음수입니다. 들어온"
        " 각 그대로 나옵니까?\n\n"
        "각을 회전에 대해 그리십시오. 오른쪽 회전이 얼마이면 0°로 똑바로 나옵니까? 회전을 더"
        " 줄수록 효과가 줄어드는 까닭은 무엇입니까?"
    ),
    "cushion-side.none": "회전이 없을 때의 각",
    "cushion-side.right": "오른쪽 회전일 때의 각",
    "cushion-side.left": "왼쪽 회전일 때의 각",
    "cushion-side.straight": "똑바로 나오는 회전",
    # -- rolling-resistance --
    "rolling-resistance.title": "구름 저항",
    "rolling-resistance.ask": (
        "공이 처음에 {speed:g} m/s로 구르다가 멈춥니다. 표는 열두 시각에서 잰 속력입니다.\n\n"
        "속력을 시간에 대해 그리고 점들을 지나는 직선을 그으십시오. 기울기가 감속도이고, 이를 g"
        " = 9.81 m/s²로 나누면 구름 저항 계수입니다. 직선은 어디에서 시간 축과 만납니까?"
        " 그때까지 간 거리는 얼마입니까(직선 아래의 넓이)?"
    ),
    "rolling-resistance.brake": "감속도",
    "rolling-resistance.roll": "구름 저항 계수",
    "rolling-resistance.time": "멈출 때까지 걸린 시간",
    "rolling-resistance.length": "멈출 때까지 간 거리",
    # -- cradle --
    "cradle.title": "뉴턴의 요람",
    "cradle.ask": (
        "0.25 kg인 공 {balls:g}개가 마찰이 없는 얼음 위에 있고, 충돌에서 잃는 것도 없습니다."
        " 서로 붙은 처음 {running:g}개가 {speed:g} m/s로 달려와, 서로 붙어 서 있는 나머지에"
        " 부딪칩니다.\n\n"
        "몇 개가 얼마의 속력으로 나갑니까? 모든 공의 운동량과 에너지를 충돌 전후로 구하십시오.\n\n"
        "공 하나가 그 운동량을 모두 가질 수도 있습니다. 그러면 속력은 얼마이고, 원래 에너지의"
        " 몇 배가 필요합니까? 그렇다면 왜 그런 일은 일어나지 않습니까?"
    ),
    "cradle.leave": "나가는 공의 수",
    "cradle.speed": "나가는 공의 속력",
    "cradle.momentum": "모든 공의 운동량",
    "cradle.energy": "모든 공의 에너지",
    "cradle.factor": "공 하나가 운동량을 모두 가질 때의 에너지 비",
    # -- pi --
    "pi.title": "충돌로 세는 π",
    "pi.ask": (
        "{ratio:g}배 무거운 공이 1 m/s로 다가와 가벼운 공을 벽으로 몹니다. 잃는 것도 마찰도"
        " 없습니다. 두 공이, 그리고 가벼운 공과 벽이 거듭 부딪치다가 마침내 무거운 공이"
        " 돌아갑니다. (게임에서는 그 뒤 반대쪽 쿠션에 닿아 충돌이 이어지니, 그 전까지만"
        " 세십시오.)\n\n"
        "√M V와 √m v를 두 축으로 잡으십시오. 에너지가 보존되므로 상태는 원 위를 움직입니다. 두"
        " 공의 충돌은 상태를 한 직선에 대해 뒤집고, 벽은 다른 직선에 대해 뒤집습니다. 두 번"
        " 뒤집으면 2θ만큼 돌고, tan θ = √(m/M)입니다. θ를 구하십시오. 반 바퀴 안에 몇 번의"
        " 충돌이 들어갑니까?\n\n"
        "질량비가 1 000 000이면 몇 번입니까? π와 견주어 보십시오."
    ),
    "pi.angle": "각 θ",
    "pi.count": "이 질량비에서의 충돌 수",
    "pi.digits": "질량비 1 000 000에서의 충돌 수",
    "pi.speed": "마지막 무거운 공의 속력",
    "pi.nearest": "무거운 공 중심과 벽의 가장 가까운 거리",
    # -- growth-of-error --
    "growth-of-error.title": "오차의 성장",
    "growth-of-error.ask": (
        "공이 1 m/s로 네 거울 사이를, 반지름 {post:g} m인 둥근 기둥 둘레를 달립니다. 처음"
        " 방향은 {angle:g}°이고, 두 번째 공은 백만분의 1도만큼 왼쪽으로 칩니다. 잃는 것은"
        " 없으며, 컴퓨터의 오차는 그 백만분의 1보다 작습니다.\n\n"
        "표는 두 공 사이의 거리입니다. 거리(미터)의 자연로그를 시간에 대해 그리고 최소제곱으로"
        " 직선을 그으십시오. 기울기가 오차의 성장률입니다. 오차가 두 배가 되는 데 얼마나"
        " 걸립니까?\n\n"
        "거리가 1 cm가 되는 때는 언제입니까? 열 배 정확하게 조준하면 얼마나 더 오래 예측할 수"
        " 있습니까? 더 정확히 재어도 별로 도움이 되지 않는 까닭은 무엇입니까?"
    ),
    "growth-of-error.rate": "성장률",
    "growth-of-error.doubling": "오차가 두 배가 되는 시간",
    "growth-of-error.centimetre": "거리가 1 cm가 되는 때",
    "growth-of-error.more": "열 배 정확한 조준으로 얻는 시간",
    # -- the figures of the thesis --
    "thesis-masse.title": "논문 그림 1: 찍어치기",
    "thesis-masse.ask": (
        "공이 x축을 따라 {speed:g} m/s로 출발합니다. 진행 방향의 회전은 {follow:g} m/s(뒤로"
        " 돎), 진행 방향을 축으로 하는 회전(찍어치기)은 {masse:g} m/s입니다. 미끄러지는 동안"
        " 천은 공의 맨 아래 점이 미끄러지는 반대쪽으로, 늘 같은 방향으로 밉니다. 그래서 길은"
        " 포물선이고, 여기서는 뒤로 휩니다.\n\n"
        "표의 속도에서 가속도의 크기(마찰 계수로, g = 9.8 m/s²)와 방향을 구하십시오. 공은 언제,"
        " 출발점에서 얼마나 떨어져 되돌아섭니까?\n\n"
        "마지막에는 속도의 5/7와 회전의 2/7가 벡터로 더해져 남습니다. 쿠션이 없다면 어느"
        " 방향으로, 얼마의 속력으로 구르겠습니까?"
    ),
    "thesis-masse.turn": "되돌아서는 때",
    "thesis-masse.farthest": "그때까지 x축을 따라 간 거리",
    "thesis-masse.push": "미는 힘과 x축 사이의 각",
    "thesis-masse.friction": "천의 마찰 계수 μ",
    "thesis-masse.speed": "구를 때의 속력",
    "thesis-masse.angle": "구르는 길과 x축 사이의 각",
    "thesis-cushion.title": "논문 그림 2: 좌우 회전과 쿠션",
    "thesis-cushion.ask": (
        "공이 처음에 {speed:g} m/s로, 오른쪽 회전 {side:g} m/s를 가지고 오른쪽 쿠션으로 똑바로"
        " 구릅니다. 논문의 법칙에서 쿠션은 부딪는 속력의 e배를 돌려주고, 구르는 공을 계속"
        " 구르게 하며, 옆으로 마찰합니다.\n\n"
        "공이 똑바로 돌아오는 선에서 벗어난 각, 비 e, 남은 좌우 회전, 잃은 에너지를 구하십시오.\n\n"
        "회전을 바꾸면 각이 바뀝니까? 게임에서 법칙(L 키)을 바꾸어 보십시오. 더는 미끄러지지"
        " 않을 때 마찰이 끝나는 법칙은 어느 것입니까?"
    ),
    "thesis-cushion.angle": "똑바른 선에서 벗어난 각",
    "thesis-cushion.ratio": "쿠션에 수직인 속력의 비(뒤/앞)",
    "thesis-cushion.side": "남은 좌우 회전",
    "thesis-cushion.lost": "잃은 에너지",
    "thesis-swap.title": "논문 그림 3: 거의 정면으로",
    "thesis-swap.ask": (
        "빨간 공이 {angle:g}° 방향으로 {red_speed:g} m/s, 노란 공이 150° 방향으로"
        " {yellow_speed:g} m/s로 달립니다. 질량은 모두 0.25 kg입니다. 두 공은 거의 정면으로"
        " 부딪칩니다. 논문의 법칙에서는 중심선 방향의 속도를 서로 바꾸고, 각각 0.95배가 됩니다.\n\n"
        "충돌 직후의 두 속력을 구하십시오. 충돌 전후의 운동량을 벡터로 더하면 얼마나 다릅니까?"
        " 자연의 법칙은 그럴 수 없습니다. 뉴턴의 어느 법칙에 어긋납니까? 병진 운동 에너지"
        " 가운데 얼마를 잃었습니까?"
    ),
    "thesis-oblique.title": "논문 그림 3: 비스듬히",
    "thesis-oblique.ask": (
        "빨간 공이 {angle:g}° 방향으로 {red_speed:g} m/s, 노란 공이 150° 방향으로"
        " {yellow_speed:g} m/s로 달립니다. 질량은 모두 0.25 kg입니다. 두 공은 비스듬히"
        " 부딪칩니다. 논문의 법칙에서는 중심선 방향의 속도를 서로 바꾸어 각각 0.95배가 되고,"
        " 그와 수직인 속도는 그대로입니다.\n\n"
        "충돌 직후의 두 속력, 잃은 운동량(벡터의 크기), 잃은 병진 운동 에너지의 비율을"
        " 구하십시오. 운동량은 어느 방향으로 사라졌고, 왜 그 방향입니까? 같은 충돌을 다른"
        " 법칙(게임의 L 키)으로 쳐서 견주어 보십시오."
    ),
    **{
        f"{name}.{field}": label
        for name in ("thesis-swap", "thesis-oblique")
        for field, label in {
            "red": "충돌 뒤 빨간 공의 속력",
            "yellow": "충돌 뒤 노란 공의 속력",
            "momentum": "잃은 운동량의 크기",
            "lost": "잃은 에너지의 비율",
        }.items()
    },
    # -- words of tables and graphs --
    "word.time": "시간", "word.way": "거리", "word.speed": "속력", "word.ball": "공",
    "word.mass": "질량", "word.vx before": "전 vx", "word.vy before": "전 vy",
    "word.vx after": "후 vx", "word.vy after": "후 vy", "word.side": "회전",
    "word.angle": "각", "word.collision": "충돌", "word.light vx": "가벼운 공 vx",
    "word.heavy vx": "무거운 공 vx", "word.distance": "거리",
    "word.log10 of distance": "log₁₀ 거리", "word.moment": "시점",
    "word.before": "직전", "word.after": "직후", "word.x": "x", "word.y": "y",
    "word.vx": "vx", "word.vy": "vy", "word.wx R": "ωx R", "word.wy R": "ωy R",
    "word.wz R": "ωz R", "word.white": "흰 공", "word.red": "빨간 공", "word.yellow": "노란 공",
    "word.light": "가벼운 공", "word.heavy": "무거운 공", "word.white x": "하양 x",
    "word.white y": "하양 y", "word.red x": "빨강 x", "word.red y": "빨강 y",
    # -- the page and the command line --
    "page.name": "이름", "page.class": "반", "page.date": "날짜", "page.sheet": "실험지",
    "page.usual": "기본 숫자", "page.seed": "숫자 {seed}번", "page.question": "문제",
    "page.measured": "측정값", "page.picture": "그림",
    "page.scale": "가는 선: 10 cm 간격. 공: {step:g}초 간격.", "page.graph": "그래프",
    "page.answers": "답", "page.asked": "구할 것", "page.answer": "답",
    "page.checked": "확인: python -m danggu lab {call} --answer 이름=숫자",
    "page.work": "풀이",
    "said.right": "맞음", "said.large": "너무 큼", "said.small": "너무 작음",
    "said.fields": "--answer 이름=숫자 로 답합니다:", "said.labs": "실험:",
}  # fmt: skip
