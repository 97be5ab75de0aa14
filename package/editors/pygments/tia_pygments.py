"""A lexer of Pygments for scenes of tia, tia-scene(5); written by tools/generate/editors.py.

    pygmentize -x -l tia_pygments.py:TiaLexer scene.tia
"""
from pygments.lexer import RegexLexer, bygroups
from pygments.token import Comment, Keyword, Name, Number, String, Text, Whitespace

__all__ = ("TiaLexer",)

FIRST = (
    "sphere", "plane", "disc", "cylinder", "cone", "box", "triangle", "torus", "rounded", "instance", "mesh", "grid",
    "material", "texture", "light", "key", "animate", "fall", "gravity", "union", "intersection", "difference",
    "group", "repeat", "end", "include", "define", "camera", "background", "samples", "depth", "fog", "lens",
    "shadows", "integrator", "spp", "filter", "tone", "exposure", "vertex", "face", "normal", "uv", "row",)
FIRST_NAMES = (
    "instance", "mesh", "grid", "material", "texture", "animate", "fall", "include", "define", "key",)
PROPERTIES = (
    "material", "appears", "vanishes", "name", "at", "rotate", "scale", "centre", "radius", "point", "normal",
    "base", "top", "capped", "radii", "min", "max", "a", "b", "c", "axis", "major", "minor", "file", "size",
    "corner", "cell", "colour", "texture", "opacity", "bump", "specular", "exponent", "refraction", "index",
    "mirror", "fresnel", "transmission", "emission", "facing", "checker", "image", "noise", "sphere", "disc",
    "rectangle", "spot", "ambient", "directional", "attenuation", "left", "right", "up", "down", "page-up",
    "page-down", "light", "camera", "direction", "velocity", "restitution", "mass", "until", "lightfield",
    "orthographic", "frustum", "perspective", "eye", "look", "fov", "distance", "height", "level", "focus", "traced",
    "rays", "zpass", "zfail", "map", "map-exact", "zpass-plain", "whitted", "ao", "path", "footprint", "none",
    "linear", "srgb", "repeat", "offset", "depth", "even", "odd", "bilinear", "low", "high", "octaves", "samples",
    "sides", "inner", "outer", "occlusion", "smooth", "width", "above", "from", "to", "window", "near",
    "tessellated", "bias", "filter", "constant", "slope", "plane", "3x3", "5x5", "7x7", "poisson", "pcss",)
NAMES = (
    "file", "image", "opacity", "name", "material", "texture", "bump",)
END = r"(?!\S)"
NAMED = r'([^\S\n]+)(?:("[^"\n]*")|([^#\s]\S*))'


def any_of(names):
    return "((?:" + "|".join(names) + ")" + END + ")"


def before_name(names, kind):
    return any_of(names) + NAMED, bygroups(kind, Whitespace, String, Name.Variable)


class TiaLexer(RegexLexer):
    """Scenes of the ray tracer tia."""

    name = "tia scene"
    aliases = ["tia"]
    filenames = ["*.tia"]
    mimetypes = ["text/x-tia"]

    tokens = {
        "root": [
            (r"[^\S\n]+|\n", Whitespace),
            (r"#.*", Comment.Single),
            (*before_name(FIRST_NAMES, Keyword), "rest"),
            (any_of(FIRST), Keyword, "rest"),
            (r"(?=.)", Text, "rest"),
        ],
        "rest": [
            (r"\n", Whitespace, "#pop"),
            (r"\\\n", Text),
            (r"[^\S\n]+", Whitespace),
            (r"#.*", Comment.Single),
            before_name(NAMES, Keyword.Type),
            (any_of(PROPERTIES), Keyword.Type),
            (r"(?:[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?:?|\d+(?:/\d*){1,2})(?=\s|$)", Number),
            (r"-?[A-Z]\S*", Name.Constant),
            (r"\S+?(?=\s|$|\\\n)", Text),
        ],
    }
