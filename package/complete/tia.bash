# tia.bash - written by tools/generate/options.py.

_tia() {
    local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} words= ends=
    # Words of one option are split at a colon and an equals sign.
    case $prev in [:=]) COMPREPLY=(); return ;; esac
    case ${1##*/} in
    tia)
        case $prev in
        -d|--display) mapfile -t COMPREPLY < <(compgen -W 'auto drm fbdev terminal none' -- "$cur"); return ;;
        -o|--output) compopt -o default; COMPREPLY=(); return ;;
        --format) mapfile -t COMPREPLY < <(compgen -W 'png ppm bmp 565 y4m tiapart pfm exr' -- "$cur"); return ;;
        --record) compopt -o default; COMPREPLY=(); return ;;
        -s|--size) COMPREPLY=(); return ;;
        --thumbnail) COMPREPLY=(); return ;;
        --eye) COMPREPLY=(); return ;;
        --look) COMPREPLY=(); return ;;
        --up) COMPREPLY=(); return ;;
        --fov) COMPREPLY=(); return ;;
        --orthographic) COMPREPLY=(); return ;;
        --samples) mapfile -t COMPREPLY < <(compgen -W '1 4 16' -- "$cur"); return ;;
        --depth) COMPREPLY=(); return ;;
        --integrator) mapfile -t COMPREPLY < <(compgen -W 'whitted ao ao= path' -- "$cur"); compopt -o nospace; return ;;
        --spp) COMPREPLY=(); return ;;
        --samples-range) COMPREPLY=(); return ;;
        --resume) compopt -o default; COMPREPLY=(); return ;;
        --time-limit) COMPREPLY=(); return ;;
        --error) COMPREPLY=(); return ;;
        --guide) mapfile -t COMPREPLY < <(compgen -W 'normal depth albedo error' -- "$cur"); return ;;
        --tone) mapfile -t COMPREPLY < <(compgen -W 'linear srgb' -- "$cur"); return ;;
        --exposure) COMPREPLY=(); return ;;
        --colour) mapfile -t COMPREPLY < <(compgen -W '565 888 16' -- "$cur"); return ;;
        --shadows) mapfile -t COMPREPLY < <(compgen -W 'traced rays zpass zfail map map-exact zpass-plain' -- "$cur"); return ;;
        --map-size) mapfile -t COMPREPLY < <(compgen -W '64 128 256 512 1024 2048 4096' -- "$cur"); return ;;
        --bias) mapfile -t COMPREPLY < <(compgen -W 'none constant= slope= normal= plane=' -- "$cur"); compopt -o nospace; return ;;
        --filter) mapfile -t COMPREPLY < <(compgen -W 'none bilinear 3x3 5x5 7x7 poisson pcss' -- "$cur"); return ;;
        --tessellated) COMPREPLY=(); return ;;
        -k|--keys) COMPREPLY=(); return ;;
        -i|--input) mapfile -t COMPREPLY < <(compgen -W 'auto evdev tty none' -- "$cur"); return ;;
        -n|--frames) COMPREPLY=(); return ;;
        --time) COMPREPLY=(); return ;;
        --fps) COMPREPLY=(); return ;;
        --frame-range) COMPREPLY=(); return ;;
        --tile-rows) COMPREPLY=(); return ;;
        -j|--threads) COMPREPLY=(); return ;;
        --arithmetic) mapfile -t COMPREPLY < <(compgen -W 'q16 f32 f64 f128' -- "$cur"); return ;;
        --rotate) mapfile -t COMPREPLY < <(compgen -W '0 90 180 270' -- "$cur"); return ;;
        --connector) mapfile -t COMPREPLY < <(compgen -W 'help' -- "$cur"); return ;;
        --mode) mapfile -t COMPREPLY < <(compgen -W 'preferred help' -- "$cur"); return ;;
        --view) mapfile -t COMPREPLY < <(compgen -W 'colour depth normal object cost light path' -- "$cur"); return ;;
        --draw-rays) COMPREPLY=(); return ;;
        --views) COMPREPLY=(); return ;;
        --lenticular) COMPREPLY=(); return ;;
        --calibration) compopt -o default; COMPREPLY=(); return ;;
        --modules) COMPREPLY=(); return ;;
        --module-range) COMPREPLY=(); return ;;
        --gaze) COMPREPLY=(); return ;;
        --view-angle) COMPREPLY=(); return ;;
        --w0) COMPREPLY=(); return ;;
        --m) COMPREPLY=(); return ;;
        --write) compopt -o default; COMPREPLY=(); return ;;
        --scene-format) mapfile -t COMPREPLY < <(compgen -W 'tia nff obj stl ply off pgm' -- "$cur"); return ;;
        -h|--help) mapfile -t COMPREPLY < <(compgen -W 'output picture display keys scene eye time paths shadows gaze lightfield farm inspect speed all' -- "$cur"); return ;;
        esac
        words='--display --output --format --record --size --thumbnail --eye --look --up --fov --orthographic --fit --samples --depth --integrator --spp --samples-range --resume --time-limit --error --denoise --guide --tone --exposure --colour --shadows --map-size --bias --filter --tessellated --keys --input --frames --inline --time --fps --frame-range --tile-rows --threads --arithmetic --dither --rotate --connector --mode --checksum --stats --stats-overlay --progress --notify --benchmark --view --draw-rays --views --lenticular --calibration --modules --module-range --gaze --view-angle --w0 --m --smooth --watch --write --list-displays --scene-format --check --strict --help --version' ends='tia nff obj stl ply off pgm' ;;
    tia-compare)
        case $prev in
        -k|--keys) COMPREPLY=(); return ;;
        --random) COMPREPLY=(); return ;;
        --rays-random) COMPREPLY=(); return ;;
        --ties) COMPREPLY=(); return ;;
        --hard) COMPREPLY=(); return ;;
        --seed) COMPREPLY=(); return ;;
        -s|--size) COMPREPLY=(); return ;;
        -j|--threads) COMPREPLY=(); return ;;
        --arithmetic) mapfile -t COMPREPLY < <(compgen -W 'f64 f128' -- "$cur"); return ;;
        --heatmap) compopt -o default; COMPREPLY=(); return ;;
        --require-identical) COMPREPLY=(); return ;;
        --max-flips) COMPREPLY=(); return ;;
        --max-levels) COMPREPLY=(); return ;;
        --every) COMPREPLY=(); return ;;
        --technique) mapfile -t COMPREPLY < <(compgen -W 'traced rays zpass zfail map map-exact zpass-plain' -- "$cur"); return ;;
        --light) COMPREPLY=(); return ;;
        --best-of) COMPREPLY=(); return ;;
        esac
        words='--keys --random --rays-random --ties --hard --seed --thesis --size --dither --threads --arithmetic --json --summary --heatmap --require-identical --max-flips --max-levels --exact --every --shadows --technique --light --best-of --help --version' ends='tia nff obj stl ply off pgm' ;;
    tia-compile)
        case $prev in
        -o|--output) compopt -o default; COMPREPLY=(); return ;;
        --memory) compopt -o default; COMPREPLY=(); return ;;
        -s|--size) COMPREPLY=(); return ;;
        --lights) COMPREPLY=(); return ;;
        --name) COMPREPLY=(); return ;;
        --crc) COMPREPLY=(); return ;;
        --rectangle) COMPREPLY=(); return ;;
        --scene-format) mapfile -t COMPREPLY < <(compgen -W 'tia nff obj stl ply off pgm' -- "$cur"); return ;;
        esac
        words='--output --memory --size --lights --name --crc --rectangle --scene-format --strict --help --version' ends='tia nff obj stl ply off pgm' ;;
    tia-join)
        case $prev in
        -o|--output) compopt -o default; COMPREPLY=(); return ;;
        --format) mapfile -t COMPREPLY < <(compgen -W 'png ppm bmp 565 y4m tiapart pfm exr' -- "$cur"); return ;;
        --share) COMPREPLY=(); return ;;
        --count) COMPREPLY=(); return ;;
        --rows) COMPREPLY=(); return ;;
        --seed) COMPREPLY=(); return ;;
        esac
        words='--output --format --verify --share --count --rows --all --seed --help --version' ends='tiapart' ;;
    tia-pov)
        case $prev in
        -o|--output) compopt -o default; COMPREPLY=(); return ;;
        --scene-format) mapfile -t COMPREPLY < <(compgen -W 'tia nff obj stl ply off pgm' -- "$cur"); return ;;
        esac
        words='--output --scene-format --strict --help --version' ends='tia nff obj stl ply off pgm' ;;
    tia-observe)
        case $prev in
        -e|--eye) COMPREPLY=(); return ;;
        -o|--output) compopt -o default; COMPREPLY=(); return ;;
        --views) COMPREPLY=(); return ;;
        --modules) COMPREPLY=(); return ;;
        --lenticular) COMPREPLY=(); return ;;
        --calibration) compopt -o default; COMPREPLY=(); return ;;
        -s|--size) COMPREPLY=(); return ;;
        --two) COMPREPLY=(); return ;;
        --to) COMPREPLY=(); return ;;
        -n|--frames) COMPREPLY=(); return ;;
        esac
        words='--eye --output --views --modules --lenticular --calibration --size --two --anaglyph --to --frames --help --version' ends='tia nff obj stl ply off pgm' ;;
    tia-radio)
        case $prev in
        --tx) COMPREPLY=(); return ;;
        --rx) COMPREPLY=(); return ;;
        -f|--frequency) COMPREPLY=(); return ;;
        --reflections) COMPREPLY=(); return ;;
        --transmissions) COMPREPLY=(); return ;;
        --method) mapfile -t COMPREPLY < <(compgen -W 'image sbr hybrid' -- "$cur"); return ;;
        --density) COMPREPLY=(); return ;;
        --material) COMPREPLY=(); return ;;
        --up) mapfile -t COMPREPLY < <(compgen -W 'y z' -- "$cur"); return ;;
        --polarization) mapfile -t COMPREPLY < <(compgen -W 'vertical horizontal' -- "$cur"); return ;;
        -o|--output) compopt -o default; COMPREPLY=(); return ;;
        -s|--size) COMPREPLY=(); return ;;
        --map) COMPREPLY=(); return ;;
        --area) COMPREPLY=(); return ;;
        --csv) compopt -o default; COMPREPLY=(); return ;;
        --range) COMPREPLY=(); return ;;
        --tile-rows) COMPREPLY=(); return ;;
        --verify) compopt -o default; COMPREPLY=(); return ;;
        --share) COMPREPLY=(); return ;;
        --count) COMPREPLY=(); return ;;
        --rows) COMPREPLY=(); return ;;
        --seed) COMPREPLY=(); return ;;
        -j|--threads) COMPREPLY=(); return ;;
        esac
        words='--tx --rx --frequency --reflections --transmissions --method --density --material --materials --up --polarization --json --output --size --map --area --csv --range --best-server --tile-rows --verify --share --count --rows --all --seed --threads --help --version' ends='tia nff obj stl ply off pgm' ;;
    tia-verify)
        case $prev in
        --share) COMPREPLY=(); return ;;
        --count) COMPREPLY=(); return ;;
        --rows) COMPREPLY=(); return ;;
        --seed) COMPREPLY=(); return ;;
        --root) COMPREPLY=(); return ;;
        --benchmark) compopt -o default; COMPREPLY=(); return ;;
        esac
        words='--share --count --rows --all --seed --root --benchmark --help --version' ends='png ppm bmp 565 pfm exr y4m tiapart record tia nff obj stl ply off pgm' ;;
    esac
    if [[ $cur == -* ]]; then mapfile -t COMPREPLY < <(compgen -W "$words" -- "$cur"); return; fi
    # Folders, and files of the right kind.
    local IFS=$'\n' end
    compopt -o filenames
    COMPREPLY=($(compgen -d -- "$cur"))
    for end in ${ends// /$IFS}; do COMPREPLY+=($(compgen -f -X "!*.$end" -- "$cur")); done
}
complete -F _tia tia tia-compare tia-compile tia-join tia-pov tia-observe tia-radio tia-verify
