"""What is made of the peers' measurements: medians, ratios and a table. Runs without any peer."""

import re
import statistics

# Of the pixels, whose relative errors are largest: reflections of a sun in pixels that are dark otherwise.
WORST_SHARE = 0.001


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


def markdown(runs_of, flip, base="velarium"):
    """A table with a row a peer, in their order; ratios are to `base`, where that was measured. `flip` has some peers."""
    summaries = {peer: summary(runs) for peer, runs in runs_of.items()}
    to = summaries.get(base, {})
    lines = [f"| renderer | process, s | of {base} | frame, ms | of {base} | peak memory, MB | of {base} | FLIP |",
             "|---|---|---|---|---|---|---|---|"]
    for peer, one in summaries.items():
        cells = [peer]
        for key, pattern, scale in (("seconds", "{:.2f}", 1), ("frame_ms", "{:.1f}", 1), ("peak_bytes", "{:.0f}", 1e-6)):
            value = one[key]
            cells.append(text(None if value is None else value * scale, pattern))
            cells.append(text(ratio(value, to.get(key)), "{:.2f}"))
        cells.append(text(flip.get(peer), "{:.3f}"))
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def cycles_seconds(log):
    """Wall seconds of path tracing alone, from what `blender --debug-cycles` prints."""
    found = re.search(r"^\s*Path Tracing\s+([\d.]+)", log, re.MULTILINE)
    if not found:
        raise ValueError("Cycles did not tell how long it traced")
    return float(found.group(1))


def speed(few, many, size):
    """Million paths a second from a run with few samples and one with many. What both do besides tracing cancels out of
    processor time; a machine so disturbed that nothing is left raises ValueError."""
    pixels = size[0] * size[1]
    cpu = many["cpu_seconds"] - few["cpu_seconds"]
    if cpu <= 0:
        raise ValueError("many samples took no more processor time than few")
    return {"wall_rate": 1e-6 * many["samples"] * pixels / many["tracing_seconds"],
            "cpu_rate": 1e-6 * (many["samples"] - few["samples"]) * pixels / cpu,
            "process_rate": 1e-6 * many["samples"] * pixels / many["seconds"],
            "seconds": many["seconds"], "peak_bytes": many["peak_bytes"]}


def pair_ratios(ours, theirs, key):
    """Of runs that followed each other, which the same disturbance met."""
    return [one[key] / other[key] for one, other in zip(ours, theirs)]


def equal_time_samples(samples, ours, theirs):
    """How many samples we trace while they trace `samples`, by processor time."""
    return max(1, round(samples * statistics.median(pair_ratios(ours, theirs, "cpu_rate"))))


def speed_markdown(runs_of, base):
    """A row a tracer: rates in million paths a second, each with the median of its ratios to `base`."""
    lines = [f"| tracer | tracing, M paths/s | of {base} | a second of processor | of {base} (least, most) | whole process | "
             f"of {base} | process, s | peak memory, MB |", "|---|---|---|---|---|---|---|---|---|"]
    for tracer, runs in runs_of.items():
        cells = [tracer]
        for key in ("wall_rate", "cpu_rate", "process_rate"):
            ratios = pair_ratios(runs, runs_of[base], key)
            spread = f" ({min(ratios):.2f}, {max(ratios):.2f})" if key == "cpu_rate" else ""
            cells += [f"{statistics.median(run[key] for run in runs):.3f}", f"{statistics.median(ratios):.2f}{spread}"]
        cells.append(f"{statistics.median(run['seconds'] for run in runs):.1f}")
        cells.append(f"{1e-6 * statistics.median(run['peak_bytes'] for run in runs):.0f}")
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def error_markdown(errors, base):
    """A row a tracer: its error at equal time from its own converged picture, and the ratio to `base`."""
    lines = [f"| tracer | paths a pixel | relative squared error | of {base} | without the worst {WORST_SHARE:.1%} | of {base} | "
             f"FLIP | of {base} |", "|---|---|---|---|---|---|---|---|"]
    for tracer, one in errors.items():
        cells = [tracer, str(one["samples"])]
        for key in ("relmse", "relmse_rest", "flip"):
            cells += [f"{one[key]:.5f}", text(ratio(one[key], errors[base][key]), "{:.2f}")]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)
