# tia.bash - written by tools/generate/completions.py from what --help says.

_tia() {
    local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} words= ends=
    # Words of one option are split at a colon and an equals sign.
    case $prev in [:=]) COMPREPLY=(); return ;; esac
    case ${1##*/} in
    tia)
        case $prev in
        -d|--display) mapfile -t COMPREPLY < <(compgen -W 'auto drm fbdev terminal none' -- "$cur"); return ;;
        -o|--output) compopt -o default; COMPREPLY=(); return ;;
        --format) mapfile -t COMPREPLY < <(compgen -W 'png ppm bmp 565 pfm y4m tiapart' -- "$cur"); return ;;
        -s|--size) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --samples) mapfile -t COMPREPLY < <(compgen -W '1 4 16' -- "$cur"); return ;;
        --depth) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --integrator) mapfile -t COMPREPLY < <(compgen -W 'whitted ao ao= path' -- "$cur"); compopt -o nospace; return ;;
        --spp) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --samples-range) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --resume) compopt -o default; COMPREPLY=(); return ;;
        --time-limit) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --error) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --guide) mapfile -t COMPREPLY < <(compgen -W 'normal depth albedo error' -- "$cur"); return ;;
        --tone) mapfile -t COMPREPLY < <(compgen -W 'linear srgb' -- "$cur"); return ;;
        --exposure) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --colour) mapfile -t COMPREPLY < <(compgen -W '565 888 16' -- "$cur"); return ;;
        --shadows) mapfile -t COMPREPLY < <(compgen -W 'traced rays zpass zfail map map-exact zpass-plain' -- "$cur"); return ;;
        --map-size) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --bias) mapfile -t COMPREPLY < <(compgen -W 'none constant= slope= normal= plane=' -- "$cur"); compopt -o nospace; return ;;
        --filter) mapfile -t COMPREPLY < <(compgen -W 'none bilinear 3x3 5x5 7x7 poisson pcss' -- "$cur"); return ;;
        --tessellated) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        -k|--keys) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        -i|--input) mapfile -t COMPREPLY < <(compgen -W 'auto evdev tty none' -- "$cur"); return ;;
        -n|--frames) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --time) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --fps) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --frame-range) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --tile-rows) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        -j|--threads) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --arithmetic) mapfile -t COMPREPLY < <(compgen -W 'q16 f32 f64' -- "$cur"); return ;;
        --rotate) mapfile -t COMPREPLY < <(compgen -W '0 90 180 270' -- "$cur"); return ;;
        --connector) mapfile -t COMPREPLY < <(compgen -W 'help' -- "$cur"); return ;;
        --mode) mapfile -t COMPREPLY < <(compgen -W 'help preferred' -- "$cur"); return ;;
        --view) mapfile -t COMPREPLY < <(compgen -W 'colour depth normal object cost light path' -- "$cur"); return ;;
        --draw-rays) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --gaze) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --view-angle) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --w0) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --m) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --views) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --lenticular) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --calibration) compopt -o default; COMPREPLY=(); return ;;
        --modules) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --module-range) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --scene-format) mapfile -t COMPREPLY < <(compgen -W 'tia nff obj' -- "$cur"); return ;;
        esac
        words='--display --output --format --size --samples --depth --integrator --spp --samples-range --resume --time-limit --error --denoise --guide --tone --exposure --colour --shadows --map-size --bias --filter --tessellated --keys --input --frames --time --fps --frame-range --tile-rows --threads --arithmetic --dither --rotate --connector --mode --checksum --stats --stats-overlay --progress --view --draw-rays --gaze --view-angle --w0 --m --smooth --views --lenticular --calibration --modules --module-range --list-displays --scene-format --strict --help --version' ends='tia nff obj' ;;
    tia-compare)
        case $prev in
        -k|--keys) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --random) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --rays-random) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --seed) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        -s|--size) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        -j|--threads) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --heatmap) compopt -o default; COMPREPLY=(); return ;;
        --require-identical) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --max-flips) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --max-levels) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --technique) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --light) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --best-of) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        esac
        words='--keys --random --rays-random --seed --thesis --size --threads --json --summary --heatmap --require-identical --max-flips --max-levels --shadows --technique --light --best-of --help --version' ends='tia nff obj' ;;
    tia-compile)
        case $prev in
        -o|--output) compopt -o default; COMPREPLY=(); return ;;
        --name) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --memory) compopt -o default; COMPREPLY=(); return ;;
        -s|--size) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --lights) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --scene-format) mapfile -t COMPREPLY < <(compgen -W 'tia nff obj' -- "$cur"); return ;;
        esac
        words='--output --name --memory --size --lights --scene-format --strict --help --version' ends='tia nff obj' ;;
    tia-join)
        case $prev in
        -o|--output) compopt -o default; COMPREPLY=(); return ;;
        --format) mapfile -t COMPREPLY < <(compgen -W 'png ppm bmp 565 pfm y4m tiapart' -- "$cur"); return ;;
        esac
        words='--output --format --help --version' ends='tiapart' ;;
    tia-pov)
        case $prev in
        -o|--output) compopt -o default; COMPREPLY=(); return ;;
        --scene-format) mapfile -t COMPREPLY < <(compgen -W 'tia nff obj' -- "$cur"); return ;;
        esac
        words='--output --scene-format --strict --help --version' ends='tia nff obj' ;;
    tia-observe)
        case $prev in
        -e|--eye) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        -o|--output) compopt -o default; COMPREPLY=(); return ;;
        --views) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --modules) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --lenticular) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --calibration) compopt -o default; COMPREPLY=(); return ;;
        -s|--size) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --two) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --to) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        -n|--frames) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        esac
        words='--eye --output --views --modules --lenticular --calibration --size --two --anaglyph --to --frames --help --version' ends='tia nff obj' ;;
    tia-radio)
        case $prev in
        --tx) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --rx) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        -f|--frequency) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --reflections) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --transmissions) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --method) mapfile -t COMPREPLY < <(compgen -W 'image sbr hybrid' -- "$cur"); return ;;
        --density) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --material) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --up) mapfile -t COMPREPLY < <(compgen -W 'y z' -- "$cur"); return ;;
        --polarization) mapfile -t COMPREPLY < <(compgen -W 'vertical horizontal' -- "$cur"); return ;;
        -o|--output) compopt -o default; COMPREPLY=(); return ;;
        -s|--size) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --map) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --area) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --csv) compopt -o default; COMPREPLY=(); return ;;
        --range) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        --tile-rows) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        -j|--threads) mapfile -t COMPREPLY < <(compgen -W '' -- "$cur"); return ;;
        esac
        words='--tx --rx --frequency --reflections --transmissions --method --density --material --materials --up --polarization --json --output --size --map --area --csv --range --best-server --tile-rows --threads --help --version' ends='tia nff obj' ;;
    esac
    if [[ $cur == -* ]]; then mapfile -t COMPREPLY < <(compgen -W "$words" -- "$cur"); return; fi
    # Folders, and files of the right kind.
    local IFS=$'\n' end
    compopt -o filenames
    COMPREPLY=($(compgen -d -- "$cur"))
    for end in ${ends// /$IFS}; do COMPREPLY+=($(compgen -f -X "!*.$end" -- "$cur")); done
}
complete -F _tia tia tia-compare tia-compile tia-join tia-pov tia-observe tia-radio
