# Completion of servodesk-cli for bash; the program itself says what fits. Files where nothing does.
_servodesk_cli() {
    local line=${COMP_LINE:0:COMP_POINT} word before
    mapfile -t COMPREPLY < <(servodesk-cli --complete "$line" 2>/dev/null | cut -f 1)
    # Readline replaces only what is behind the last ":" or "=" of the word.
    word=${line##* }
    before=${word%"${word##*[:=]}"}
    COMPREPLY=("${COMPREPLY[@]#"$before"}")
}
complete -o default -F _servodesk_cli servodesk-cli
