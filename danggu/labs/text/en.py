"""What labs say in English."""

TEXT = {
    # -- five-sevenths --
    "five-sevenths.title": "The 5/7 law",
    "five-sevenths.ask": (
        "A ball is struck in its middle, so it begins at {speed:g} m/s without spin. It slides:"
        " the cloth brakes it and makes it turn, until it rolls. The table gives its speed at"
        " some moments.\n\n"
        "Draw the speed over time. Find the moment at which the line bends: from there on the"
        " ball rolls. By what factor has the speed fallen? What share of the kinetic energy,"
        " rotation included, has the cloth taken? From the slope, what is the coefficient of"
        " friction of the cloth (g = 9.81 m/s²)?\n\n"
        "Then think further: with draw, a backward spin, the ball rolls more slowly in the end."
        " With how much draw (the speed of its surface) would it lie still instead of rolling?"
        " Try it."
    ),
    "five-sevenths.speed": "speed at which it begins to roll",
    "five-sevenths.time": "time until it rolls",
    "five-sevenths.length": "distance until it rolls",
    "five-sevenths.friction": "friction of the cloth μ",
    "five-sevenths.lost": "share of the energy that is lost",
    "five-sevenths.draw": "draw with which it stops, as a number above 0",
    # -- right-angle --
    "right-angle.title": "The 90° rule and restitution",
    "right-angle.ask": (
        "The white runs at {speed:g} m/s and meets the red, which lies still; its draw has just"
        " been used up, so it slides without turning. The line of centres is {cut:g}° off its"
        " path. Both balls weigh the same, and friction between them is left out.\n\n"
        "Were nothing lost, the two would part at a right angle: why? Here a little is lost"
        " along the line of centres. Compute from the table the angle between the two paths"
        " right after the hit, and both speeds; measure the angle in the picture, too.\n\n"
        "The red leaves along the line of centres. Take the components of the white's velocity"
        " along that line before and after, and find the restitution e."
    ),
    "right-angle.angle": "angle between the two paths",
    "right-angle.white": "speed of the white after the hit",
    "right-angle.red": "speed of the red after the hit",
    "right-angle.e": "restitution e",
    # -- thirty-degrees --
    "thirty-degrees.title": "The 30° rule",
    "thirty-degrees.ask": (
        "The white rolls at {speed:g} m/s along the x axis and meets the red at a cut of"
        " {cut:g}° (the angle between the line of centres and its path). Nothing is lost in the"
        " hit. Right after it the white slides at a right angle to the red; but it has kept the"
        " spin with which it rolled, so its path bends forward until it rolls again.\n\n"
        "Find by how much the white is turned right after the hit, and by how much in the end."
        " Players say: by about 30°, for any hit that is neither thin nor full.\n\n"
        "Change the cut (in the game, or with other numbers) and find the greatest turn there"
        " is."
    ),
    "thirty-degrees.red": "direction of the red, from the x axis",
    "thirty-degrees.first": "turn of the white right after the hit",
    "thirty-degrees.last": "turn of the white once it rolls again",
    "thirty-degrees.greatest": "greatest turn of all cuts",
    # -- momentum-energy --
    "momentum-energy.title": "Momentum and energy in a hit",
    "momentum-energy.ask": (
        "The white ({white_mass:g} kg) and the red ({red_mass:g} kg) slide towards each other"
        " and meet. The table gives the velocities right before and right after.\n\n"
        "Fill in the table of momenta: p = m v for each ball, x and y, and their sum, before"
        " and after. Is momentum conserved, in both directions? Do the same for the"
        " translational kinetic energy, m v²/2. How much has gone, and where to?\n\n"
        "The impulse is along the line of centres: find its direction from the change of one"
        " ball's momentum, and then the restitution e, the ratio of the speeds along that line"
        " with which the balls part and closed."
    ),
    "momentum-energy.px": "sum of the momenta along x",
    "momentum-energy.py": "sum of the momenta along y",
    "momentum-energy.before": "kinetic energy of both before",
    "momentum-energy.after": "kinetic energy of both after",
    "momentum-energy.e": "restitution e",
    # -- unknown-mass --
    "unknown-mass.title": "An unknown mass",
    "unknown-mass.ask": (
        "The white weighs {known:g} kg and runs at {speed:g} m/s. The red, as large, lies"
        " still; nobody has weighed it. The line of centres is {cut:g}° off the white's path.\n\n"
        "From the velocities in the table, what does the red weigh? Both components give an"
        " answer: do they agree? Which is less affected by errors of measurement?\n\n"
        "Find the restitution e as well, and the share of the translational kinetic energy"
        " that is lost."
    ),
    "unknown-mass.mass": "mass of the red",
    "unknown-mass.e": "restitution e",
    "unknown-mass.lost": "share of the energy that is lost",
    # -- cushion-side --
    "cushion-side.title": "Angle off a cushion against side",
    "cushion-side.ask": (
        "A ball rolls at {speed:g} m/s towards the right cushion, {angle:g}° off the normal"
        " to it. It is played without side, with {side:g} m/s of side to the right (the"
        " speed of its surface), and with as much to the left.\n\n"
        "The table has the velocities right before and right after, for five sides. Find the"
        " angle with which the ball leaves, from the normal to the cushion: above 0"
        " where it goes on along the cushion, below 0 where it comes back. Does it leave as it"
        " came?\n\n"
        "Draw the angle against the side. With how much side to the right does the ball leave"
        " straight, at 0°? Why does more side matter less and less?"
    ),
    "cushion-side.none": "angle without side",
    "cushion-side.right": "angle with side to the right",
    "cushion-side.left": "angle with side to the left",
    "cushion-side.straight": "side with which it leaves straight",
    # -- rolling-resistance --
    "rolling-resistance.title": "Rolling resistance",
    "rolling-resistance.ask": (
        "A ball rolls along the table, at {speed:g} m/s to begin with, until it lies still. The"
        " table has its speed at twelve moments.\n\n"
        "Draw the speed over time and put a line through the points. Its slope is the"
        " deceleration; divided by g = 9.81 m/s² it is the coefficient of rolling resistance."
        " Where does the line meet the axis? How far has the ball come by then? (The area under"
        " the line.)"
    ),
    "rolling-resistance.brake": "deceleration",
    "rolling-resistance.roll": "coefficient of rolling resistance",
    "rolling-resistance.time": "time until it lies still",
    "rolling-resistance.length": "distance until it lies still",
    # -- cradle --
    "cradle.title": "Newton's cradle",
    "cradle.ask": (
        "{balls:g} balls of 0.25 kg, on ice, so that nothing rubs; nothing is lost when they"
        " hit. The first {running:g} touch each other and run at {speed:g} m/s into the others,"
        " which touch each other and lie still.\n\n"
        "How many leave, and how fast? Compute momentum and energy of all balls together,"
        " before and after.\n\n"
        "One ball alone could carry all of that momentum. How fast would it be, and how many"
        " times the energy there was would it need? So why does it not happen?"
    ),
    "cradle.leave": "how many balls leave",
    "cradle.speed": "their speed",
    "cradle.momentum": "momentum of all balls",
    "cradle.energy": "energy of all balls",
    "cradle.factor": "the energy one ball would need, over that there is",
    # -- pi --
    "pi.title": "The digits of π by collisions",
    "pi.ask": (
        "A ball {ratio:g} times as heavy as another drives it into a wall, at 1 m/s. Nothing is"
        " lost and nothing rubs. The two, and the light one and the wall, collide again and"
        " again, until the heavy one is on its way back for good. (In the game it then comes to"
        " the table's other cushion, and more follows: count to the last collision before"
        " that.)\n\n"
        "Take √M V and √m v as the axes of a plane. Energy makes the state move on a circle, a"
        " hit of the balls mirrors it, the wall mirrors it again; two mirrors turn it by 2θ"
        " with tan θ = √(m/M). Find θ. How many collisions fit into a half turn?\n\n"
        "Now a ratio of 1 000 000: how many collisions are there? Compare with π."
    ),
    "pi.angle": "the angle θ",
    "pi.count": "collisions at this ratio",
    "pi.digits": "collisions at a ratio of 1 000 000",
    "pi.speed": "speed of the heavy ball in the end",
    "pi.nearest": "least distance of its centre from the wall",
    # -- growth-of-error --
    "growth-of-error.title": "Growth of error",
    "growth-of-error.ask": (
        "A ball runs at 1 m/s among four mirrors around a round post of {post:g} m radius,"
        " aimed at {angle:g}°. A second shot is aimed a millionth of a degree to the left."
        " Nothing is lost, and the computer errs by less than a millionth of that.\n\n"
        "The table has the distance between the two. Draw its logarithm over time and put a"
        " line through the points by least squares (natural logarithms of the distance in"
        " metres): its slope is the rate at which errors grow. How long does an error take to"
        " double?\n\n"
        "When is the distance one centimetre? By how much longer could one foresee the ball,"
        " were it aimed ten times as well? Why does it not help much to measure better?"
    ),
    "growth-of-error.rate": "rate of growth",
    "growth-of-error.doubling": "time in which an error doubles",
    "growth-of-error.centimetre": "when the distance is 1 cm",
    "growth-of-error.more": "time won by aiming ten times as well",
    # -- the figures of the thesis --
    "thesis-masse.title": "Thesis, figure 1: a massé",
    "thesis-masse.ask": (
        "A ball runs at {speed:g} m/s along the x axis, with {follow:g} m/s of spin against its"
        " motion and {masse:g} m/s about its path (massé). While it slides, the cloth pushes it"
        " against the slip of its lowest point, always in the same direction: so its path is a"
        " parabola, which here bends back.\n\n"
        "From the velocities in the table, find the acceleration: its size, as friction (g ="
        " 9.8 m/s²), and its direction. When and how far from its start does the ball turn"
        " back?\n\n"
        "In the end 5/7 of the velocity and 2/7 of the spin are left, each as a vector. Were"
        " there no cushions, how fast and in which direction would it roll?"
    ),
    "thesis-masse.turn": "when it turns back",
    "thesis-masse.farthest": "how far along x it has come by then",
    "thesis-masse.push": "angle between the push and the x axis",
    "thesis-masse.friction": "friction of the cloth μ",
    "thesis-masse.speed": "speed with which it would roll",
    "thesis-masse.angle": "angle between its path, rolling, and the x axis",
    "thesis-cushion.title": "Thesis, figure 2: a cushion with side",
    "thesis-cushion.ask": (
        "A ball rolls straight into the right cushion, at {speed:g} m/s to begin with, with"
        " {side:g} m/s of side to the right. By the thesis's law, the cushion returns a share e"
        " of the speed against it, keeps the ball rolling, and rubs at its side.\n\n"
        "Find the angle off the straight line with which the ball comes back, the share e, the"
        " side that is left, and the energy that is lost.\n\n"
        "Change the side: does the angle change? Then change the laws in the game (key L). With"
        " which law does friction end where nothing slips any more?"
    ),
    "thesis-cushion.angle": "angle off the straight line",
    "thesis-cushion.ratio": "speed against the cushion, after over before",
    "thesis-cushion.side": "side that is left",
    "thesis-cushion.lost": "energy that is lost",
    "thesis-swap.title": "Thesis, figure 3: nearly head-on",
    "thesis-swap.ask": (
        "Red runs at {red_speed:g} m/s towards {angle:g}°, yellow at {yellow_speed:g} m/s"
        " towards 150°; both weigh 0.25 kg. They meet nearly head-on. By the thesis's law the"
        " two swap the parts of their velocities along the line of centres, each times 0.95.\n\n"
        "Find both speeds right after the hit. Add the momenta before and after as vectors: by"
        " how much do they differ? A law of nature may not do that: which of Newton's laws is"
        " broken? What share of the translational kinetic energy is lost?"
    ),
    "thesis-oblique.title": "Thesis, figure 3: oblique",
    "thesis-oblique.ask": (
        "Red runs at {red_speed:g} m/s towards {angle:g}°, yellow at {yellow_speed:g} m/s"
        " towards 150°; both weigh 0.25 kg. They meet obliquely. By the thesis's law the two"
        " swap the parts of their velocities along the line of centres, each times 0.95, and"
        " keep those across it.\n\n"
        "Find both speeds right after the hit, the momentum that is lost, as the length of a"
        " vector, and the share of the translational kinetic energy. In which direction is momentum"
        " lost, and why in that one? Play the same hit with another law (key L in the game) and"
        " compare."
    ),
    **{
        f"{name}.{field}": label
        for name in ("thesis-swap", "thesis-oblique")
        for field, label in {
            "red": "speed of the red after the hit",
            "yellow": "speed of the yellow after the hit",
            "momentum": "momentum that is lost, its size",
            "lost": "share of the energy that is lost",
        }.items()
    },
    # -- words of tables and graphs --
    "word.time": "time", "word.way": "distance", "word.speed": "speed", "word.ball": "ball",
    "word.mass": "mass", "word.vx before": "vx before", "word.vy before": "vy before",
    "word.vx after": "vx after", "word.vy after": "vy after", "word.side": "side",
    "word.angle": "angle", "word.collision": "collision", "word.light vx": "light, vx",
    "word.heavy vx": "heavy, vx", "word.distance": "distance",
    "word.log10 of distance": "log₁₀ of the distance", "word.moment": "moment",
    "word.before": "before", "word.after": "after", "word.x": "x", "word.y": "y",
    "word.vx": "vx", "word.vy": "vy", "word.wx R": "ωx R", "word.wy R": "ωy R",
    "word.wz R": "ωz R", "word.white": "white", "word.red": "red", "word.yellow": "yellow",
    "word.light": "light", "word.heavy": "heavy", "word.white x": "white x",
    "word.white y": "white y", "word.red x": "red x", "word.red y": "red y",
    # -- the page and the command line --
    "page.name": "Name", "page.class": "Class", "page.date": "Date", "page.sheet": "Sheet",
    "page.usual": "usual numbers", "page.seed": "numbers {seed}", "page.question": "Question",
    "page.measured": "Measured", "page.picture": "Picture",
    "page.scale": "Thin lines: every 10 cm. Balls: every {step:g} s.", "page.graph": "Graph",
    "page.answers": "Answers", "page.asked": "asked for", "page.answer": "answer",
    "page.checked": "Check: python -m danggu lab {call} --answer FIELD=NUMBER",
    "page.work": "Working",
    "said.right": "right", "said.large": "too large", "said.small": "too small",
    "said.fields": "Answer with --answer FIELD=NUMBER:", "said.labs": "Labs:",
}  # fmt: skip
