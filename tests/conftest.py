# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rules that hold for every test."""

import os
from collections.abc import Generator
from typing import Any

import pytest
from hypothesis import settings

# The same examples in every run, on machines of any speed: a failure is then always a change's.
settings.register_profile("gpswb", derandomize=True, deadline=None)
settings.load_profile("gpswb")


@pytest.fixture(scope="session", autouse=True)
def _no_cache_of_the_user(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Results of earlier runs would hide a change's failure; subprocesses inherit this, too."""
    os.environ["XDG_CACHE_HOME"] = str(tmp_path_factory.mktemp("cache"))


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport() -> Generator[None, Any, None]:
    _fail_if_skipped((yield).get_result())


@pytest.hookimpl(hookwrapper=True)
def pytest_make_collect_report() -> Generator[None, Any, None]:
    _fail_if_skipped((yield).get_result())


def _fail_if_skipped(report: pytest.TestReport | pytest.CollectReport) -> None:
    """A test that is skipped, for want of a kernel say, has shown nothing: it fails."""
    if report.skipped:
        report.outcome = "failed"
        report.longrepr = f"skipped, which counts as failed: {report.longrepr}"
