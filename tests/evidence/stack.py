"""stack.py - the most bytes of stack of each public function of the span core, by the call graph of tests/slow/freestanding."""
import importlib.machinery
import importlib.util
import os
import subprocess
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))


def freestanding():
    loader = importlib.machinery.SourceFileLoader("slow_freestanding", os.path.join(HERE, "..", "slow", "freestanding"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("slow_freestanding", loader))
    loader.exec_module(module)
    return module


def table():
    """A row in Markdown for each processor and function; and functions without a bound."""
    module = freestanding()
    lines, unbounded = ["| function | " + " | ".join(target[0] for target in module.TARGETS[1:]) + " |",
                        "|---|" + "--:|" * len(module.TARGETS[1:])], []
    columns = []
    for _, prefix, options, *_ in module.TARGETS[1:]:
        with tempfile.TemporaryDirectory() as folder:
            try:
                module.compile_core(prefix, options, module.SMALL_SOURCES, folder)
            except (OSError, subprocess.CalledProcessError):
                columns.append(None)
                continue
            calls, depths = module.stack_of(folder, module.PUBLIC)
            unbounded += calls.unbounded
            columns.append(depths)
    for function in module.PUBLIC:
        cells = ["not compiled here" if column is None else str(column[function][0]) for column in columns]
        lines.append(f"| `{function}` | " + " | ".join(cells) + " |")
    deepest = [max(column.values()) for column in columns if column]
    if deepest:
        lines += ["", "The deepest chain: " + " > ".join(max(deepest)[1]) + "."]
    return lines, unbounded
