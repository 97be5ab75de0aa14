"""slips.py - breaks the core as requirements.txt says, one slip at a time, in a copy: a test of the requirement must fail.

    slips.py [WORD...]          those whose name has one of the words"""
import importlib.machinery
import importlib.util
import os
import shutil
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
import mutants  # noqa: E402
import requirements  # noqa: E402


def mutate():
    """The functions of tests/mutate."""
    loader = importlib.machinery.SourceFileLoader("mutate", os.path.join(HERE, "..", "mutate"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("mutate", loader))
    loader.exec_module(module)
    return module


def noticed_by(module, folder, mutant, tests):
    """The test that fails with the slip, None if none does, or "" if the copy does not build."""
    target = os.path.join(folder, mutant.path)
    text = module.read(target)
    module.write(target, module.change(mutant, text))
    try:
        return module.failure(folder, tests)
    finally:
        module.write(target, text)


def run(words=()):
    """Yields (requirement, slip, what noticed it)."""
    module = mutate()
    every = {mutant.what: mutant for room in mutants.rooms() for mutant in room.mutants}
    with tempfile.TemporaryDirectory() as folder:
        for name in module.FOLDERS:
            if os.path.isdir(name):
                shutil.copytree(name, os.path.join(folder, name))
            elif os.path.exists(name):
                shutil.copy2(name, folder)
        for requirement in requirements.requirements(requirements.read(requirements.FILE)):
            tests = [program for program, _ in requirement.tests]
            for name in requirement.mutants:
                if not words or any(word in name for word in words):
                    yield requirement, name, noticed_by(module, folder, every[name], tests)


def main(words):
    failed = 0
    for requirement, name, found in run(words):
        failed += not found
        print(f"{'ok' if found else 'FAIL'} {name}: {found or ('does not build' if found == '' else 'no test notices')}"
              f" ({requirement.sentence[:50]}...)", flush=True)
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
