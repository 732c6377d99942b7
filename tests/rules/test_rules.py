"""The rules of the carom games, judged stroke by stroke: the cases R1 to R22 and their corners."""

from typing import NamedTuple

import pytest

from danggu.rules.carom import Carom
from danggu.rules.free import Free
from danggu.rules.match import Match, Player
from danggu.rules.sagu import EXTRA_3C, LAST_POINT_3C, Sagu
from danggu.rules.stroke import LEFT, TIE
from danggu.rules.verdict import Turn, Verdict
from physics import Shot, scenes, simulate
from tests.support.event_log import BEAT, EAST, NORTH, R1, R2, RED, SOUTH, WEST, YELLOW, entry, log


def sagu(*steps: str, score: int = 5, target: int | None = 10, **options: object) -> Verdict:
    return Sagu(**options).verdict(log(*steps), Turn("white", score=score, target=target))  # type: ignore[arg-type]


def three(*steps: str, opening: bool = False, **options: object) -> Verdict:
    return Carom(**options).verdict(log(*steps), Turn("white", opening, 5, 10))  # type: ignore[arg-type]


def straight(*steps: str) -> Verdict:
    return Carom(cushions=0).verdict(log(*steps), Turn())


def outcome(verdict: Verdict) -> tuple[str, int, bool]:
    return verdict.reason, verdict.points, verdict.passes


# The cases R1 to R22


def test_r1_both_reds_score_and_the_player_goes_on() -> None:
    verdict = sagu(R1, R2)
    assert outcome(verdict) == ("both_reds", 1, False)
    assert (verdict.made, verdict.foul, verdict.won) == (True, False, False)


def test_r2_one_red_is_no_point_and_no_foul() -> None:
    verdict = sagu(R1)
    assert outcome(verdict) == ("one_red", 0, True)
    assert not verdict.foul


def test_r3_no_red_is_a_foul_and_costs_a_point() -> None:
    verdict = sagu(WEST)
    assert outcome(verdict) == ("no_red", -1, True)
    assert verdict.foul


def test_r3_no_red_at_a_score_of_zero_costs_nothing() -> None:
    assert outcome(sagu(WEST, score=0)) == ("no_red", 0, True)


def test_r4_the_opponents_ball_after_one_red_is_a_foul() -> None:
    assert outcome(sagu(R1, YELLOW)) == ("opponent_ball", -1, True)


def test_r5_the_opponents_ball_after_both_reds_voids_the_point() -> None:
    verdict = sagu(R1, R2, YELLOW)
    assert outcome(verdict) == ("opponent_ball", -1, True)
    assert not verdict.made


def test_r6_a_red_may_touch_the_opponents_ball() -> None:
    assert outcome(sagu(R1, "red1-yellow", R2)) == ("both_reds", 1, False)


def test_r7_the_same_red_twice_is_one_red() -> None:
    assert outcome(sagu(R1, R1, WEST)) == ("one_red", 0, True)


def test_r8_a_last_point_without_three_cushions_is_none() -> None:
    verdict = sagu(R1, R2, score=9, finish=LAST_POINT_3C)
    assert outcome(verdict) == ("few_cushions", 0, True)
    assert (verdict.won, verdict.foul) == (False, False)


def test_r9_a_last_point_off_three_cushions_wins() -> None:
    verdict = sagu(R1, WEST, NORTH, EAST, R2, score=9, finish=LAST_POINT_3C)
    assert outcome(verdict) == ("both_reds_3c", 1, False)
    assert verdict.won


def test_r10_three_cushions_after_the_last_point_win() -> None:
    verdict = sagu(WEST, NORTH, R1, EAST, R2, score=10, finish=EXTRA_3C)
    assert outcome(verdict) == ("both_reds_3c", 0, False)
    assert verdict.won


def test_r11_the_score_stays_at_zero() -> None:
    assert outcome(sagu(YELLOW, score=0)) == ("opponent_ball", 0, True)


def test_r11_the_score_may_go_below_zero_where_the_house_says_so() -> None:
    assert sagu(YELLOW, score=0, floor_zero=False).points == -1


def test_r12_ball_three_cushions_ball_is_a_point() -> None:
    assert outcome(three(YELLOW, WEST, NORTH, EAST, RED)) == ("cannon", 1, False)


def test_r13_cushion_ball_two_cushions_ball_is_a_point() -> None:
    assert three(WEST, YELLOW, NORTH, EAST, RED).points == 1


def test_r14_three_cushions_before_both_balls_are_a_point() -> None:
    assert three(WEST, NORTH, EAST, YELLOW, RED).points == 1


def test_r15_a_third_cushion_after_the_second_ball_is_late() -> None:
    assert outcome(three(YELLOW, WEST, NORTH, RED, EAST)) == ("few_cushions", 0, True)


@pytest.mark.parametrize("last", [("white|east", "=red-white"), ("red-white", "=white|east")])
def test_r16_third_cushion_and_second_ball_at_the_same_instant_are_no_point(
    last: tuple[str, str],
) -> None:
    assert outcome(three(YELLOW, WEST, NORTH, *last)) == ("same_instant", 0, True)


def test_r17_the_same_rail_again_is_another_contact() -> None:
    assert three(YELLOW, WEST, NORTH, WEST, RED).points == 1
    assert three(YELLOW, WEST, NORTH, NORTH, RED).points == 1


def test_r18_the_first_ball_twice_is_no_second_ball() -> None:
    assert outcome(three(YELLOW, WEST, NORTH, EAST, YELLOW)) == ("one_ball", 0, True)


def test_r19_the_opening_stroke_must_hit_the_red_first() -> None:
    verdict = three(YELLOW, WEST, NORTH, EAST, RED, opening=True)
    assert outcome(verdict) == ("opening_not_red", 0, True)
    assert verdict.foul
    assert three(RED, WEST, NORTH, EAST, YELLOW, opening=True).points == 1


def test_r20_a_ball_off_the_table_is_a_foul_and_is_to_be_spotted() -> None:
    verdict = three(YELLOW, WEST, NORTH, EAST, RED, "red!")
    assert outcome(verdict) == ("off_table", 0, True)
    assert (verdict.foul, verdict.facts.off) == (True, ("red",))
    assert outcome(sagu(R1, R2, "white!")) == ("off_table", -1, True)


def test_a_ball_that_jumps_off_the_table_is_a_foul() -> None:
    world = scenes.carom()
    after = simulate(world, "white", Shot(3.0, angle=90.0, climb=2.0))
    verdict = Sagu().verdict(after.log.contacts(), Turn("white", score=5, target=10))
    assert outcome(verdict) == ("off_table", -1, True)


def test_r21_straight_rail_takes_any_cannon() -> None:
    assert outcome(straight(YELLOW, RED)) == ("cannon", 1, False)


def test_r22_straight_rail_needs_both_balls() -> None:
    assert outcome(straight(YELLOW, YELLOW)) == ("one_ball", 0, True)


# Ties and contacts that last


def three_with_gap(gap: float) -> Verdict:
    """The third cushion `gap` s before the second ball."""
    entries = log(YELLOW, WEST, NORTH)
    entries += [entry(1.0 - gap, EAST), entry(1.0, RED)]
    entries.sort(key=lambda e: e.time)
    return Carom().verdict(entries, Turn("white"))


def test_a_third_cushion_just_before_the_ball_counts_and_just_after_does_not() -> None:
    assert three_with_gap(2 * TIE).points == 1
    assert three_with_gap(0.5 * TIE).reason == "same_instant"
    assert three_with_gap(-0.5 * TIE).reason == "same_instant"
    assert three_with_gap(-2 * TIE).reason == "few_cushions"


def test_a_fourth_cushion_at_the_instant_of_the_ball_does_no_harm() -> None:
    assert three(YELLOW, WEST, NORTH, EAST, SOUTH, "=red-white").points == 1


def test_on_the_opening_both_balls_at_one_instant_are_the_red_first() -> None:
    verdict = three(WEST, NORTH, EAST, YELLOW, "=red-white", opening=True)
    assert outcome(verdict) == ("bank_cannon", 1, False)


def test_a_ball_pressed_into_a_cushion_by_its_spin_touches_it_once() -> None:
    first = entry(1.0, WEST)
    pressed = [entry(1.0 + i * BEAT, WEST, away=LEFT) for i in range(1, 50)]
    verdict = Carom().verdict([*log(YELLOW), first, *pressed, entry(9.0, RED)], Turn())
    assert (verdict.points, verdict.facts.cushions) == (0, 1)


def test_a_cushion_that_was_left_counts_again_however_soon() -> None:
    left = {"away": 1.01 * LEFT}
    quick = [entry(1.0, WEST), entry(1.002, YELLOW), entry(1.004, WEST, **left)]
    verdict = Carom().verdict([*quick, entry(1.006, WEST, **left), entry(2.0, RED)], Turn())
    assert (verdict.points, verdict.facts.cushions) == (1, 3)


def test_a_cushion_never_left_does_not_count_again_off_a_ball() -> None:
    quick = [entry(1.0, WEST), entry(1.002, YELLOW), entry(1.004, WEST, away=0.5 * LEFT)]
    verdict = Carom().verdict([*quick, entry(1.5, NORTH), entry(2.0, RED)], Turn())
    assert (verdict.points, verdict.facts.cushions) == (0, 2)
    assert verdict.facts.path == ("west", "yellow", "north", "red")


def test_a_cushion_that_the_ball_is_frozen_to_is_no_contact_of_the_stroke() -> None:
    frozen = [entry(0.0, WEST, away=0.0), *log(NORTH, YELLOW, EAST, RED)]
    verdict = Carom().verdict(frozen, Turn())
    assert (verdict.points, verdict.facts.bank) == (0, 1)


def test_a_log_that_does_not_say_how_far_a_ball_was_away_counts_every_contact() -> None:
    class Bare(NamedTuple):
        time: float
        kind: str
        balls: tuple[str, ...]
        wall: str | None = None

    bare = [Bare(e.time, e.kind, e.balls, e.wall) for e in log(WEST, WEST, WEST, YELLOW, RED)]
    assert Carom().verdict(bare, Turn()).points == 1  # type: ignore[arg-type]


def test_cushions_of_other_balls_do_not_count() -> None:
    assert three(YELLOW, "yellow|west", "yellow|north", "yellow|east", RED).points == 0


def test_rolling_and_resting_are_nothing_to_the_rules() -> None:
    assert sagu("white", R1, "red1", R2, "white") == sagu("white", R1, "red1", R2, "white", "red2")


# What the card says


def test_the_facts_name_balls_and_cushions_in_order() -> None:
    facts = sagu(WEST, R2, NORTH, EAST, R1, SOUTH, R1).facts
    assert facts.hits == ("red2", "red1")
    assert (facts.cushions, facts.bank) == (3, 1)
    assert facts.path == ("west", "red2", "north", "east", "red1")
    assert facts.decided == pytest.approx(5 * BEAT)


def test_an_undecided_stroke_gives_all_facts() -> None:
    facts = three(YELLOW, WEST, NORTH).facts
    assert (facts.hits, facts.cushions, facts.decided) == (("yellow",), 2, None)


def test_a_bank_shot_is_worth_two_where_the_house_says_so() -> None:
    assert outcome(three(WEST, RED, NORTH, EAST, YELLOW, bank=2)) == ("bank_cannon", 2, False)
    assert outcome(three(RED, WEST, NORTH, EAST, YELLOW, bank=2)) == ("cannon", 1, False)


def test_a_miss_at_three_cushion_is_no_foul() -> None:
    verdict = three(WEST, NORTH)
    assert outcome(verdict) == ("no_ball", 0, True)
    assert not verdict.foul


def test_one_cushion_needs_one() -> None:
    assert three(YELLOW, RED, cushions=1).points == 0
    assert three(YELLOW, WEST, RED, cushions=1).points == 1


def test_the_yellow_player_scores_with_the_yellow_ball() -> None:
    turn = Turn("yellow", score=3)
    assert Sagu().verdict(log("yellow-red1", "yellow-red2"), turn).points == 1
    assert Sagu().verdict(log("yellow-red1", R2, YELLOW), turn).reason == "opponent_ball"


def test_the_free_table_judges_nothing_and_gives_all_facts() -> None:
    match = Match.of(Free(), Player("a"))
    verdict = match.judged(log(YELLOW, WEST, R1))
    assert outcome(verdict) == ("free", 0, False)
    assert verdict.facts.hits == ("yellow", "red1")
    assert match.after(verdict).at == 0


@pytest.mark.parametrize("wrong", [{"finish": "soon"}, {"penalty": -1}])
def test_an_unknown_house_rule_is_refused(wrong: dict[str, object]) -> None:
    with pytest.raises(ValueError, match=next(iter(wrong))):
        Sagu(**wrong)  # type: ignore[arg-type]


@pytest.mark.parametrize("wrong", [{"cushions": 2}, {"penalty": -1}, {"bank": 0}])
def test_an_unknown_cannon_game_is_refused(wrong: dict[str, object]) -> None:
    with pytest.raises(ValueError, match=next(iter(wrong))):
        Carom(**wrong)  # type: ignore[arg-type]
