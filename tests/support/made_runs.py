# SPDX-License-Identifier: Apache-2.0
"""Folders of runs made by hand, small enough that every number in them is known."""

import json
import pathlib

SCENARIO = """name = "made"
[robots]
count = 2
source_m = [-4.0, 0.0]
destination_m = [4.0, 0.0]
[algorithm]
cruise_mps = 1.0
sharing_starts_s = 5.0
[experiment]
items = 2
[world]
arena_m = [12.0, 12.0]
[[world.box]]
centre_m = [0.0, 3.0]
size_m = [1.0, 2.0]
yaw_rad = 0.5
[[world.cylinder]]
centre_m = [0.0, -3.0]
radius_m = 0.5
[[world.outline]]
points_m = [[2.0, 2.0], [3.0, 2.0], [2.5, 3.0]]
"""


def robot(number: int, found_s: float | None = None, received_s: float | None = None, items: int = 0,
          path_length_m: float | None = None) -> dict:
    return {"id": number, "found_s": found_s, "received_s": received_s, "items": items, "path_length_m": path_length_m,
            "driving_s": 15.0, "exchanging_s": 1.0, "avoiding_s": 4.0, "stuck_s": 0.0, "idle_s": 0.0,
            "longest_stuck_s": 0.0}


def metrics(mode: str = "full", seed: int = 1, **changes) -> dict:
    """Robot 1 finds a path after 4 s and robot 2 receives it after 8 s; both deliver one item within 20 s."""
    made = {"scenario": "made", "engine": "embedded", "mode": mode, "seed": seed, "robots": 2, "ended": True,
            "completed": True, "disturbed": False, "interrupted": False, "failure": "", "items_delivered": 2,
            "sim_time_s": 20.0, "round_trip_mean_s": 8.0, "routes": 1,
            "exchanges": {"completed": 1, "failed": 1, "mean_duration_s": 0.5},
            "contacts": {"robot_robot": 1, "robot_static": 0},
            "per_robot": [robot(1, found_s=4.0, items=1, path_length_m=8.0),
                          robot(2, received_s=8.0, items=1, path_length_m=9.0)]}
    return made | changes


def make_run(folder: pathlib.Path, mode: str = "full", seed: int = 1, **changes) -> pathlib.Path:
    """Both robots drive along x, robot 1 at 1 m/s; robot 2 stands next to the point that robot 1 passes at 10 s."""
    folder.mkdir(parents=True)
    (folder / "metrics.json").write_text(json.dumps(metrics(mode, seed, **changes)))
    (folder / "scenario.toml").write_text(SCENARIO)
    tracks = ["time_s,robot,x_m,y_m,yaw_rad,mode"]
    for second in range(21):
        tracks.append(f"{second}.000,1,{second - 10:.4f},0.0000,0.00000,transport")
        tracks.append(f"{second}.000,2,0.0000,1.0000,0.00000,transport")
    (folder / "tracks.csv").write_text("\n".join(tracks) + "\n")
    (folder / "trips.csv").write_text("robot,trip,picked_up_s,delivered_s,next_pick_up_s\n"
                                      "1,1,6.000,10.000,14.000\n1,2,14.000,,\n2,1,9.000,18.000,\n")
    (folder / "events.csv").write_text(
        "time_s,robot,event,detail\n6.000,1,pick_up,\n"
        "8.000,1,exchange,partner=2 session=7 primary=false completed=false began_s=7.500 ended_s=8.000\n"
        "8.000,2,exchange,partner=1 session=7 primary=true completed=true began_s=7.500 ended_s=8.000\n"
        "9.000,2,exchange,partner=1 session=0 primary=true completed=false began_s=8.500 ended_s=9.000\n"
        "10.000,1,contact,with=2\n10.000,1,contact,with=static\n"
        "10.000,1,delivery,items=1\n18.000,2,delivery,items=2\n")
    (folder / "paths.csv").write_text("robot,index,x_m,y_m\n1,0,-4.0000,0.0000\n1,1,4.0000,0.0000\n"
                                      "2,0,-4.0000,0.0000\n2,1,0.0000,2.0000\n2,2,4.0000,0.0000\n")
    (folder / "activities.csv").write_text(
        "time_s,robot,activity\n0.000,1,driving\n7.500,1,exchanging\n8.000,1,driving\n11.000,1,avoiding\n"
        "13.000,1,driving\n0.000,2,driving\n")
    (folder / "path_lengths.csv").write_text("time_s,robot,length_m\n4.000,1,20.000\n12.000,1,8.000\n8.000,2,9.000\n")
    return folder
