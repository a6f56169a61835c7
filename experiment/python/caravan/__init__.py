# SPDX-License-Identifier: Apache-2.0
"""Runs of Caravan from scripts and notebooks.

    import caravan

    scenario = caravan.Scenario.load("deploy/scenarios/small.toml").changed({"seed": 3, "radio.range_m": 3.0})
    run = caravan.Run(scenario)
    run.run(until_s=60)
    print(run.poses(), run.metrics()["items_delivered"])

docs/notebooks.md is the tutorial."""

from caravan._engine import RunError, ScenarioError
from caravan.records import Records, run_over_dds, to_frame
from caravan.run import Run
from caravan.scenario import Scenario

__all__ = ["Records", "Run", "RunError", "Scenario", "ScenarioError", "run_over_dds", "to_frame"]
