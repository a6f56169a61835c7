# SPDX-License-Identifier: Apache-2.0
"""The results that the paper reports of its three runs, one for each mode, by the names of our quantities. Sections 4 and 5 of
the paper and its figures 8 to 13; numbers with (log) are computed from the logs that were published with its code."""

PAPER = {
    "time to the last item, min": {"none": "51", "partial": "51", "full": "70; 67 (log)"},
    "items delivered": {"none": "100", "partial": "100", "full": "100"},
    "robots that found a path themselves": {"none": "14", "partial": "9", "full": "8 (log)"},
    "robots that received their path": {"none": "0", "partial": "6", "full": "7 (log)"},
    "robots that never had a path": {"none": "1", "partial": "0", "full": "0"},
    "robots with a path at 15 min": {"partial": "6", "full": "6"},
    "robots with a path at 18 min": {"full": "13"},
    "last but one robot got a path at, min": {"none": "34"},
    "all robots had a path at, min": {"none": "never", "full": "19; 18 (log)"},
    "mean round trip, s": {"none": "315", "partial": "315", "full": "434"},
    "routes at the end": {"none": "7", "partial": "3", "full": "1"},
    "shortest path at the end, m": {"full": "49.8 (log)"},
    "longest path at the end, m": {"full": "49.8 (log)"},
    "fewest items of a robot": {"none": "0", "partial": "3", "full": "nearly equal"},
    "most items of a robot": {"none": "14", "partial": "11", "full": "nearly equal"},
    "exchanges completed": {"none": "0", "full": "410 with failed ones"},
    "exchanges a minute once allowed": {"full": "7.5"},
    "mean duration of an exchange, s": {"full": "1.7"},
}
ROUND_TRIP_S = {"none": 315.0, "partial": 315.0, "full": 434.0}
TIME_MIN = {"none": 51.0, "partial": 51.0, "full": 70.0}
ITEMS = 100
