"""How a reference picture changes."""

import pathlib

import pytest

from grading import bless, manifest
from grading.bless import Recipe, WrongPicture
from grading.errors import GradingError, UsageError
from grading.manifest import ROOT

EXERCISE = bless.find_exercise("01.8")


def with_tolerance(max_difference: float, total_pixels: int) -> Recipe:
    first = bless.recipes(EXERCISE)[0]
    return Recipe(first.file, first.command, max_difference, total_pixels, "a test")


def test_unknown_exercise_is_refused() -> None:
    with pytest.raises(UsageError, match="expected an id"):
        bless.find_exercise("01.99")


def test_every_reference_belongs_to_an_exercise() -> None:
    for stage in manifest.STAGES:
        if (ROOT / stage).is_dir():
            ids = tuple(f"{exercise.id}_" for exercise in manifest.exercises(stage))
            assert [p.name for p in (ROOT / stage / "expected").glob("*.png") if not p.name.startswith(ids)] == []


def test_wrong_answers_draw_another_picture_or_none(tmp_path: pathlib.Path) -> None:
    chosen = bless.recipes(EXERCISE)
    pictures = bless.make_pictures(chosen, tmp_path / "right")
    wrong = bless.wrong_pictures(EXERCISE, chosen, tmp_path / "wrong")
    drawn = [picture for recipe in chosen for picture in wrong[recipe.file]]
    assert not [picture for picture in drawn if picture.what == "the starter"]
    assert any(bless.differs(picture.path, pictures[chosen[0].file]) for picture in drawn)


def test_tolerance_is_refused_for_every_wrong_picture_it_lets_pass(tmp_path: pathlib.Path) -> None:
    picture = bless.make_pictures([with_tolerance(0, 0)], tmp_path / "out")[with_tolerance(0, 0).file]
    others = bless.other_pictures(EXERCISE, tmp_path, picture)
    wrong = [*others, WrongPicture("the starter", others[-1].path), WrongPicture("the known mistake", others[-1].path)]
    assert bless.refused(with_tolerance(0, 0), picture, wrong) == []
    faults = "\n".join(bless.refused(with_tolerance(255, 10**9), picture, wrong))
    for what in ("an empty picture", "of another exercise", "the starter", "the known mistake"):
        assert what in faults


def test_the_same_picture_is_no_fault_of_a_tolerance(tmp_path: pathlib.Path) -> None:
    picture = bless.make_pictures([with_tolerance(0, 0)], tmp_path)[with_tolerance(0, 0).file]
    same = WrongPicture("a mistake that does not show", picture)
    assert bless.refused(with_tolerance(255, 10**9), picture, [same]) == []
    assert bless.unseen(picture, [same]) == [same.what]


def test_recipe_that_writes_nothing_is_an_error(tmp_path: pathlib.Path) -> None:
    recipe = Recipe("01.8_missing.png", with_tolerance(0, 0).command, 0, 0, "a test")
    with pytest.raises(GradingError, match="expected it to write"):
        bless.make_pictures([recipe], tmp_path)


def test_references_are_replaced_whole(tmp_path: pathlib.Path) -> None:
    (tmp_path / "made").mkdir()
    (tmp_path / "expected").mkdir()
    old = tmp_path / "expected" / "01.8_a.png"
    old.write_bytes(b"old")
    (tmp_path / "made" / "01.8_a.png").write_bytes(b"new")
    bless.replace([tmp_path / "made" / "01.8_a.png"], tmp_path / "expected")
    assert [path.read_bytes() for path in (tmp_path / "expected").iterdir()] == [b"new"]


def test_before_after_and_difference_are_shown(tmp_path: pathlib.Path, capsys: pytest.CaptureFixture[str]) -> None:
    one, other = (ROOT / "01_lines/expected" / name for name in ("01.5_bresenham.png", "01.5_ten_steps.png"))
    assert bless.show(with_tolerance(0, 0), one, other, tmp_path)
    assert len(list(tmp_path.iterdir())) == 3
    assert "before" in capsys.readouterr().out
    assert not bless.show(with_tolerance(0, 0), one, one, tmp_path)
