#!/usr/bin/python3
"""The stored integers of a scene file, read from the C source that tia-compile(1) writes, for definition.py.

    definition_scene.py SCENE [KEYS] > SCENE.json
"""
import json
import os
import re
import subprocess
import sys

COMPILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "build", "tia-compile")


def value(token, tokens):
    """A C initialiser that begins with a token: an integer, a list, a dictionary of designated fields, or a word."""
    if token != "{":
        return int(token.rstrip("u")) if re.fullmatch(r"-?\d+u?", token) else token
    fields, items = {}, []
    for token in tokens:
        if token == "}":
            break
        if token.startswith("."):
            next(tokens)  # the sign =
            fields[token[1:]] = value(next(tokens), tokens)
        elif token != ",":
            items.append(value(token, tokens))
    return fields or items


def tables(source):
    """The initialised objects of the source, by their names without the prefix scene_."""
    result = {}
    for name, body in re.findall(r"const struct tia_\w+ (scene\w*)(?:\[\])? = (\{.*?\});", source, re.DOTALL):
        tokens = iter(re.findall(r"[{},=]|'.'|[-.\w&]+", body))
        result[name.removeprefix("scene_")] = value(next(tokens), tokens)
    return result


def light_of(fields):
    if fields.get("kind") != "TIA_POINT_LIGHT":
        raise ValueError("a light that is not a point light")
    if any(fields.get(name) for name in ("constant", "linear", "quadratic")):
        raise ValueError("a light with attenuation")
    zero = [0, 0, 0]
    return {"centre": fields.get("centre", zero), "radius": fields.get("radius", 0),
            "emission": fields.get("emission", zero)}


def material_of(fields):
    strange = set(fields) - {"colour", "transmission", "emission", "emission_bits"}
    if strange:
        raise ValueError("a material with " + ", ".join(strange))
    return {name: fields.get(name, [0, 0, 0]) for name in ("colour", "transmission", "emission")}


def read(path, keys=""):
    """The scene with the lights of the pressed keys; a JSON file is that already."""
    if path.endswith(".json"):
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    source = subprocess.run([COMPILE, path, "-o", "-"], check=True, capture_output=True, text=True).stdout
    found = tables(source)
    camera, scene = found["scene"].get("camera", {}), found["scene"]
    if scene.get("shape_count") or any(camera.get(name) for name in ("up", "samples")):
        raise ValueError("a scene that the definition does not cover")
    lights = [light_of(fields) for fields in found.get("lights", [])]
    for key in keys:
        binding = next(b for b in found["bindings"] if b["key"] == f"'{key}'")
        number = min(binding.get("light", 0), len(lights))
        lights[number:number + 1] = [light_of(binding["state"])]
    spheres = [{"centre": centre, "radius": radius, "material": material}
               for centre, radius, material in found.get("spheres", [])]
    return {"camera": {"eye": camera.get("eye", [0, 0, 0]), "fov": camera["fov"]},
            "background": scene.get("background", [0, 0, 0]),
            "materials": [material_of(fields) for fields in found.get("materials", [])],
            "spheres": spheres, "lights": lights}


if __name__ == "__main__":
    json.dump(read(*sys.argv[1:3]), sys.stdout, indent=1)
