"""What was measured: the rows of the comparison (`lgs bench --json`) and of the engine (`lgs_bench`)."""

import json
import re


class Results:
    def __init__(self, about, comparison, engine):
        self.about = about  # machine, compiler, commit, command, date
        self.comparison = {(row["scenario"], row["subject"]): row for row in comparison}
        self.engine = {}
        for row in engine:
            name = re.sub(r"(/iterations:\d+)?(/real_time)?$", "", row["name"])
            row["real_ns"] = row["real_time"] * {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}[row["time_unit"]]
            self.engine[name] = row

    def median(self, scenario, subject):
        """A median in ns, or None if it was not measured."""
        row = self.comparison.get((scenario, subject))
        return row and row["median_ns"]

    def of(self, name):
        """A row of the engine, empty if it was not measured."""
        return self.engine.get(name, {})

    def write_json(self, path):
        everything = {
            "about": self.about,
            "comparison": list(self.comparison.values()),
            "engine": list(self.engine.values()),
        }
        path.write_text(json.dumps(everything, indent=1, ensure_ascii=False) + "\n")
