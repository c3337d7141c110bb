# Completion of servodesk-cli for fish; the program itself says what fits. Files where nothing does.
function __servodesk_cli
    set -l found (servodesk-cli --complete (commandline -cp | string collect) 2>/dev/null)
    if test (count $found) -gt 0
        printf '%s\n' $found
    else
        __fish_complete_path (commandline -ct)
    end
end
complete -c servodesk-cli -f -a '(__servodesk_cli)'
