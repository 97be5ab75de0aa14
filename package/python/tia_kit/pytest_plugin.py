"""For pytest: the fixture `tia_golden`.

    def test_scene(tia_golden):
        tia_golden(draw("scene.tia", (160, 120)), "golden/scene.ppm")

The golden file is read relative to the test's. It is written by `pytest --tia-bless`, and when a test fails the picture of
differences is written beside it as NAME.difference.png."""
import os

import pytest

from .picture import assert_same, load, save


def pytest_addoption(parser):
    parser.addoption("--tia-bless", action="store_true", help="write the golden pictures of the fixture tia_golden")


@pytest.fixture
def tia_golden(request):
    """A function that compares a picture with a golden .ppm file."""
    here = os.path.dirname(str(request.path if hasattr(request, "path") else request.fspath))

    def check(picture, golden):
        path = os.path.join(here, golden)
        if request.config.getoption("--tia-bless"):
            save(path, picture)
            return
        assert os.path.exists(path), f"{path} is missing: pytest --tia-bless writes it"
        assert_same(picture, load(path), os.path.splitext(path)[0] + ".difference.png")

    return check
