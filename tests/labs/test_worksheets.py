"""Worksheets: whose numbers they have, how answers are checked, and that both languages say all."""

import re
from math import isfinite
from string import Formatter

import pytest

from danggu import labs
from danggu.labs import text
from physics import scenes

BOTH = text.LANGUAGES["en"], text.LANGUAGES["ko"]


def scale(field, truth):
    """How far from the truth an answer may be."""
    return max(field.slack, field.within * abs(truth))


@pytest.mark.parametrize("name", labs.LABS)
def test_the_engine_has_a_finite_value_for_each_field_and_takes_it(name):
    sheet = labs.lab(name, 11)
    assert {*sheet.truth} == {field.name for field in sheet.fields}
    assert all(map(isfinite, sheet.truth.values()))
    assert all(sheet.check(sheet.truth).values())


@pytest.mark.parametrize("name", labs.LABS)
def test_an_answer_is_right_within_its_tolerance_and_wrong_beyond_it_on_either_side(name):
    sheet = labs.lab(name, 5)
    for field in sheet.fields:
        truth = sheet.truth[field.name]
        far = scale(field, truth)
        for way in (1, -1):
            near, off = (
                sheet.check({field.name: truth + way * (share * far + 1e-6 * (share > 1.0))})
                for share in (0.99, 1.01)
            )
            assert near[field.name] == (field.name, truth + way * 0.99 * far, True, 0)
            assert (off[field.name].right, off[field.name].way) == (False, way)


def test_an_answer_may_be_text_as_people_type_it():
    sheet = labs.lab("cushion-side")
    typed = f" −{abs(sheet.truth['right']):.2f} "
    assert sheet.truth["right"] < 0.0
    assert sheet.check(right=typed)["right"]


@pytest.mark.parametrize("value", ["", "fast", "nan", "inf", None, True, [1.0], 1 << 2000])
def test_an_answer_that_is_no_number_is_refused_with_the_name_of_its_field(value):
    with pytest.raises(ValueError, match="leave: an answer is a number, not"):
        labs.lab("cradle").check(leave=value)


def test_a_field_that_there_is_not_is_refused_with_the_names_of_those_there_are():
    with pytest.raises(ValueError, match="'cradle' has no field 'sped': there are leave, speed"):
        labs.lab("cradle").check(sped=1.0)


@pytest.mark.parametrize("seed", [-1, 1.5, "7", True, 2**63])
def test_a_seed_is_a_whole_number(seed):
    with pytest.raises(ValueError, match="the seed must be a whole number from 0 on"):
        labs.lab("pi", seed)


def test_a_lab_that_there_is_not_is_refused_with_the_names_of_those_there_are():
    with pytest.raises(ValueError, match="no lab 'pie': there are five-sevenths"):
        labs.lab("pie")


@pytest.mark.parametrize("name", labs.LABS)
def test_numbers_of_a_seed_are_on_their_grid_and_always_the_same(name):
    lab = labs.LABS[name]
    for seed in range(40):
        numbers = lab.numbers(seed)
        assert numbers == lab.numbers(seed)
        for one in lab.given:
            steps = (numbers[one.name] - one.low) / one.step
            assert abs(steps - round(steps)) < 1e-6
            assert one.low <= numbers[one.name] <= one.high
    # at most a few of forty students share all their numbers with another
    assert len({(*lab.numbers(seed).values(),) for seed in range(40)}) >= 12


def test_the_numbers_of_a_seed_are_those_of_every_machine():
    assert labs.lab("five-sevenths", 1).numbers == {"speed": 1.2, "friction": 0.28}
    assert labs.lab("pi", 5).numbers == {"ratio": 348.0}


@pytest.mark.parametrize(
    ("name", "scene"),
    [("thesis-masse", "thesis_1"), ("thesis-cushion", "thesis_2"), ("thesis-swap", "thesis_3a"),
     ("thesis-oblique", "thesis_3b")],
)  # fmt: skip
def test_the_usual_numbers_of_the_figures_are_those_of_the_thesis_to_the_bit(name, scene):
    ours, its = labs.lab(name).world(), scenes.SCENES[scene]()
    assert ours.layout() == its.layout()
    ours.run()
    its.run()
    assert [(e.time, e.kind, e.point) for e in ours.log] == [
        (e.time, e.kind, e.point) for e in its.log
    ]


@pytest.mark.parametrize("name", labs.LABS)
def test_a_scene_begins_in_motion_each_time_as_it_did_the_first(name):
    sheet = labs.lab(name, 3)
    first, second = sheet.world(), sheet.world()
    assert not first.at_rest
    assert first.layout() == second.layout()
    assert first.time == second.time == 0.0


def test_both_languages_say_the_same_things_with_the_same_numbers():
    english, korean = BOTH
    assert {*english} == {*korean}
    for key in english:
        places = ({part[1] for part in Formatter().parse(one[key])} - {None} for one in BOTH)
        assert next(places) == next(places), key


@pytest.mark.parametrize("language", text.LANGUAGES)
@pytest.mark.parametrize("name", labs.LABS)
def test_every_lab_is_asked_in_words_that_name_no_hidden_number(name, language):
    sheet = labs.lab(name, 8)
    say = text.of(language)
    heads = [*sheet.table().heads, *sheet.lab.axes]
    assert all(f"word.{head.partition(' (')[0]}" in say for head in heads)
    assert all(sheet.label(field.name, language) for field in sheet.fields)
    assert len(sheet.question(language).split("\n\n")) >= 2
    shown = {part[1] for part in Formatter().parse(say[f"{name}.ask"])}
    assert not shown & {one.name for one in sheet.lab.given if one.hidden}


def test_korean_is_korean():
    words = [key for key in BOTH[1] if not re.search("[가-힣]", BOTH[1][key])]
    assert all(key.startswith("word.") for key in words), words


def test_what_a_lab_shows_beside_its_own_shot_has_been_played():
    for name, count in (("cushion-side", 3), ("growth-of-error", 2), ("cradle", 1)):
        figure = labs.lab(name).figure()
        assert len(figure) == count
        assert all(world.time > 0.0 for world in figure)
