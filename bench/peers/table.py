"""What is made of the peers' measurements: medians, ratios and a table. Runs without any peer."""

import statistics


def summary(runs):
    """Medians of runs of one peer. A run: seconds, peak bytes and, where the peer tells it, milliseconds a frame."""
    frames = [run["frame_ms"] for run in runs if run.get("frame_ms") is not None]
    return {"seconds": statistics.median(run["seconds"] for run in runs),
            "peak_bytes": statistics.median(run["peak_bytes"] for run in runs),
            "frame_ms": statistics.median(frames) if frames else None}


def ratio(value, base):
    return None if value is None or not base else value / base


def text(value, pattern):
    return "-" if value is None else pattern.format(value)


def markdown(runs_of, base="velarium"):
    """A table with a row a peer, in their order; ratios are to `base`, where that was measured."""
    summaries = {peer: summary(runs) for peer, runs in runs_of.items()}
    to = summaries.get(base, {})
    lines = [f"| renderer | process, s | of {base} | frame, ms | of {base} | peak memory, MB | of {base} |",
             "|---|---|---|---|---|---|---|"]
    for peer, one in summaries.items():
        cells = [peer]
        for key, pattern, scale in (("seconds", "{:.2f}", 1), ("frame_ms", "{:.1f}", 1), ("peak_bytes", "{:.0f}", 1e-6)):
            value = one[key]
            cells.append(text(None if value is None else value * scale, pattern))
            cells.append(text(ratio(value, to.get(key)), "{:.2f}"))
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)
