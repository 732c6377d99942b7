"""Whole games played by hand-written logs, and what always holds."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from danggu.rules.carom import Carom
from danggu.rules.match import Match, Player
from danggu.rules.sagu import EXTRA_3C, LAST_POINT_3C, NONE, Sagu
from danggu.rules.verdict import Turn, Verdict
from tests.support.event_log import EAST, NORTH, R1, R2, RED, SOUTH, WEST, YELLOW, FakeEvent, log

# Whole games

POINT, POINT_3C, MISS, FOUL = (R1, R2), (R1, WEST, NORTH, EAST, R2), (R1,), (WEST,)


def as_yellow(steps: tuple[str, ...]) -> tuple[str, ...]:
    aside = (step.replace("white", "*") for step in steps)
    return tuple(step.replace("yellow", "white").replace("*", "yellow") for step in aside)


def played(match: Match, *strokes: tuple[str, ...]) -> Match:
    """The match after strokes that are written for the white ball."""
    for steps in strokes:
        own = steps if match.cue == "white" else as_yellow(steps)
        match = match.after(match.judged(log(*own)))
    return match


def two(finish: str = NONE, targets: tuple[int, int] = (3, 2), **options: object) -> Match:
    players = (Player("kim", targets[0]), Player("lee", targets[1]))
    return Match.of(Sagu(finish, **options), *players)  # type: ignore[arg-type]


def test_a_game_to_the_target_is_won_by_its_last_point() -> None:
    match = played(two(), POINT, POINT)
    assert not match.finished
    assert played(match, POINT).winner == 0


def test_each_player_has_a_handicap_of_his_own() -> None:
    match = played(two(), POINT, POINT, MISS, POINT)
    assert (match.missing(0), match.missing(1), match.finished) == (1, 1, False)
    assert played(match, POINT).winner == 1


def test_a_last_point_must_come_off_three_cushions_over_a_whole_game() -> None:
    match = played(two(LAST_POINT_3C), POINT, POINT, POINT)
    assert (match.sheets[0].score, match.at) == (2, 1)
    match = played(match, MISS, POINT_3C)
    assert (match.winner, match.sheets[0].score) == (0, 3)


def test_an_extra_three_cushion_follows_the_last_point_over_a_whole_game() -> None:
    match = played(two(EXTRA_3C), POINT, POINT, POINT)
    assert (match.sheet.score, match.at, match.finished) == (3, 0, False)
    match = played(match, POINT)
    assert (match.sheets[0].score, match.at, match.finished) == (3, 1, False)
    match = played(match, MISS, POINT_3C)
    assert (match.winner, match.sheets[0].score) == (0, 3)


def test_a_foul_before_the_extra_stroke_means_the_last_point_again() -> None:
    match = played(two(EXTRA_3C), POINT, POINT, POINT, FOUL, MISS, POINT_3C)
    assert (match.sheets[0].score, match.finished) == (3, False)
    assert played(match, POINT_3C).winner == 0


def test_fouls_cost_what_the_house_says_and_stop_at_zero() -> None:
    match = played(two(penalty=2, targets=(9, 9)), POINT, FOUL)
    assert (match.sheets[0].score, match.sheets[0].fouls) == (0, 1)
    match = played(two(penalty=2, floor_zero=False), FOUL)
    assert match.sheets[0].score == -2


def test_innings_average_and_high_run() -> None:
    strokes = (POINT, POINT, MISS, MISS, POINT, MISS, MISS, POINT)
    match = played(two(targets=(20, 20)), *strokes)
    sheet = match.sheets[0]
    assert (sheet.score, sheet.innings, sheet.best, sheet.strokes, sheet.made) == (4, 3, 2, 6, 4)
    assert sheet.average == 4 / 3
    assert (match.inning, match.run, match.at) == (3, 1, 0)
    assert match.sheets[1].average == 0


def test_a_foul_does_not_shorten_the_high_run() -> None:
    match = played(two(targets=(20, 20)), POINT, POINT, FOUL)
    assert (match.sheets[0].score, match.sheets[0].best) == (1, 2)


def test_players_take_turns_with_their_own_cue_balls() -> None:
    match = two()
    assert (match.cue, match.opening) == ("white", True)
    match = played(match, MISS)
    assert (match.cue, match.opening, match.player.name) == ("yellow", False, "lee")
    assert played(match, MISS).cue == "white"


def test_one_player_alone_starts_an_inning_with_every_miss() -> None:
    match = played(Match.of(Sagu(), Player("kim")), POINT, MISS, MISS)
    assert (match.at, match.cue, match.inning, match.sheet.innings) == (0, "white", 3, 2)
    assert not match.finished


def test_only_the_first_stroke_of_a_match_is_the_opening() -> None:
    match = Match.of(Carom(), Player("kim", 5), Player("lee", 5))
    foul = match.judged(log(YELLOW, WEST, NORTH, EAST, RED))
    assert foul.reason == "opening_not_red"
    match = match.after(foul)
    assert match.judged(log("yellow-white", "yellow|west", "yellow|east", "yellow|west",
                            "yellow-red")).points == 1  # fmt: skip


def test_a_turn_can_be_passed_on_and_costs_no_inning() -> None:
    match = two().passed()
    assert (match.at, match.sheets[0].innings) == (1, 0)


def test_nothing_is_played_after_the_end() -> None:
    match = played(two(targets=(1, 1)), POINT)
    with pytest.raises(ValueError, match="over"):
        match.after(Verdict("both_reds"))


def test_a_match_needs_players_and_a_player_a_target_above_zero() -> None:
    with pytest.raises(ValueError, match="player"):
        Match.of(Sagu())
    with pytest.raises(ValueError, match="kim"):
        Player("kim", 0)


# Whatever happens

STEPS = st.sampled_from(
    [R1, R2, YELLOW, WEST, EAST, NORTH, SOUTH, "red1-yellow", "red2|west", "red1-red2", "white"]
)
PLAIN = st.sampled_from([POINT, POINT_3C, MISS, FOUL])
STROKES = st.one_of(PLAIN, st.lists(STEPS, max_size=8).map(tuple))
THREE_STEPS = st.sampled_from([YELLOW, RED, WEST, EAST, NORTH, SOUTH, "red-yellow", "red|west"])
FINISH = st.sampled_from([NONE, LAST_POINT_3C, EXTRA_3C])


@given(st.lists(STROKES, max_size=12), FINISH, st.integers(0, 4))
def test_a_score_with_a_floor_never_falls_below_zero_nor_rises_above_the_target(
    strokes: list[tuple[str, ...]], finish: str, penalty: int
) -> None:
    match = two(finish, penalty=penalty)
    for steps in strokes:
        if not match.finished:
            match = played(match, steps)
        for sheet, target in zip(match.sheets, (3, 2), strict=True):
            assert 0 <= sheet.score <= target


@given(st.lists(STROKES, max_size=12), FINISH)
def test_the_turn_passes_exactly_when_no_point_is_made(
    strokes: list[tuple[str, ...]], finish: str
) -> None:
    match = two(finish)
    for steps in strokes:
        own = steps if match.cue == "white" else as_yellow(steps)
        verdict = match.judged(log(*own))
        assert verdict.passes == (not verdict.made)
        assert not (verdict.foul and verdict.made)
        after = match.after(verdict)
        assert (after.at != match.at) == verdict.passes
        if after.finished:
            return
        match = after


@given(st.lists(STROKES, max_size=10))
def test_undo_is_keeping_old_values(strokes: list[tuple[str, ...]]) -> None:
    history = [two(targets=(99, 99))]
    for steps in strokes:
        history.append(played(history[-1], steps))
    for i, steps in enumerate(strokes):
        assert played(history[i], steps) == history[i + 1]
    assert history[0] == two(targets=(99, 99))


@given(st.lists(THREE_STEPS, max_size=8), st.lists(THREE_STEPS, max_size=4), st.booleans())
def test_what_comes_after_the_second_ball_changes_no_three_cushion(
    steps: list[str],
    more: list[str],
    opening: bool,
) -> None:
    turn = Turn(opening=opening)
    done = Carom().verdict(log(*steps, YELLOW, RED), turn)
    assert Carom().verdict(log(*steps, YELLOW, RED, *more), turn) == done


@given(st.lists(STEPS, max_size=8), st.lists(STEPS, max_size=4))
def test_what_comes_after_the_opponents_ball_changes_no_foul(
    steps: list[str], more: list[str]
) -> None:
    done = Sagu().verdict(log(*steps, YELLOW), Turn(score=5))
    later = Sagu().verdict(log(*steps, YELLOW, *more), Turn(score=5))
    assert (later.reason, later.points, later.facts.path) == ("opponent_ball", -1, done.facts.path)


@given(st.lists(THREE_STEPS, max_size=10), st.booleans(), st.sampled_from([0, 1, 3]))
def test_a_verdict_that_is_settled_in_mid_stroke_is_the_last_one(
    steps: list[str], opening: bool, cushions: int
) -> None:
    rules, turn = Carom(cushions, bank=2), Turn(opening=opening, score=3, target=4)
    last = rules.verdict(log(*steps), turn)
    for count in range(len(steps)):
        so_far = rules.verdict(log(*steps[:count]), turn)
        if rules.settles(so_far):
            assert outcome(so_far) == outcome(last)
    hit = {YELLOW, RED} & {*steps}
    assert rules.settles(last) == (len(hit) == 2 or (last.reason == "opening_not_red"))


@given(st.lists(STEPS, max_size=10), FINISH, st.integers(0, 4))
def test_in_4_ball_a_foul_is_settled_and_a_point_is_not(
    steps: list[str], finish: str, score: int
) -> None:
    rules, turn = Sagu(finish), Turn(score=score, target=4)
    last = rules.verdict(log(*steps), turn)
    for count in range(len(steps)):
        so_far = rules.verdict(log(*steps[:count]), turn)
        if rules.settles(so_far):
            assert outcome(so_far) == outcome(last)
    assert rules.settles(last) == (YELLOW in steps)


def outcome(verdict: Verdict) -> tuple[object, ...]:
    return verdict.reason, verdict.points, verdict.made, verdict.foul, verdict.won, verdict.passes


@given(st.lists(THREE_STEPS, max_size=8))
def test_the_order_of_names_in_an_entry_means_nothing(steps: list[str]) -> None:
    turned = [FakeEvent(e.time, e.kind, e.balls[::-1], e.wall) for e in log(*steps)]
    assert Carom().verdict(turned, Turn()) == Carom().verdict(log(*steps), Turn())
