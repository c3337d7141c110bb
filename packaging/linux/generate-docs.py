#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the manual pages and shell completions of the three programs, from what they say of themselves:
servodesk-cli by its command table (help --json), the others by --help through help2man.

Usage: generate-docs.py FOLDER_OF_THE_PROGRAMS OUTPUT_FOLDER"""
import json
import os
import subprocess
import sys

PORTS = "sim:demo sim:trouble sim:modbus sim:lx sim:so101"
ENVIRONMENT = {**os.environ, "LC_ALL": "C.UTF-8", "QT_QPA_PLATFORM": "offscreen"}


def run(*command):
    return subprocess.run(command, env=ENVIRONMENT, check=True, capture_output=True, text=True).stdout


def write(folder, path, text):
    path = os.path.join(folder, path)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def roff(text):
    """As text of a manual page: no macros, no hyphens that become dashes."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return text.replace("\n.", "\n\\&.").replace("\n'", "\n\\&'")


def sentence(text):
    return text[0].upper() + text[1:] + "."


def bold(text):
    return "\\fB" + roff(text) + "\\fR"


def options_of(options):
    lines = []
    for one in options:
        value = " \\fI" + roff(one["value"]) + "\\fR" if one["value"] else ""
        lines += [".TP", bold(one["flag"]) + value, roff(one["help"]) + "."]
    return lines


def man_page(table):
    lines = [
        f'.TH SERVODESK\\-CLI 1 "" "ServoDesk {table["version"]}" "User Commands"',
        ".SH NAME",
        "servodesk\\-cli \\- find, read, configure and drive serial bus servos",
        ".SH SYNOPSIS",
        ".B servodesk\\-cli",
        "[\\fIOPTIONS\\fR] \\fICOMMAND\\fR \\fI...\\fR",
        ".SH DESCRIPTION",
        "Searches the bus, reads and changes memory tables without losing a setting, drives servos and tests",
        "them. It does what the window of",
        ".BR servodesk (1)",
        "does; both share the history of writes and tests.",
        ".SH OPTIONS",
        *options_of(table["options"]),
    ]
    for group in table["groups"]:
        lines.append(".SH " + roff(group["title"].rstrip(":")).upper())
        for command in group["commands"]:
            lines += [".SS " + roff(command["usage"]), roff(sentence(command["help"]))]
            for one in command["arguments"]:
                lines += [".TP", "\\fI" + roff(one["name"]) + "\\fR", roff(one["help"]) + "."]
            lines += options_of(command["options"])
            if command["examples"]:
                lines += [".PP", ".nf"]
                lines += ["    servodesk\\-cli " + roff(example) for example in command["examples"]]
                lines += [".fi"]
    lines += [
        ".SH EXIT STATUS",
        "0 success, 1 not executed by the servo, 2 usage error, 3 port error, 4 no reply, 5 file error.",
        ".SH SEE ALSO",
        ".BR servodesk (1),",
        ".BR servodesk\\-sim (1)",
    ]
    return "\n".join(lines) + "\n"


def commands_of(table):
    return [command for group in table["groups"] for command in group["commands"]]


def bash_completion(table):
    first = sorted({command["name"].split()[0] for command in commands_of(table)} | {"help"})
    members = {}
    cases = []
    for command in commands_of(table):
        words = command["name"].split()
        if len(words) == 2:
            members.setdefault(words[0], []).append(words[1])
        flags = " ".join(option["flag"] for option in command["options"])
        cases.append(f'            "{command["name"]}") options+=" {flags}" ;;')
    groups = "\n".join(
        f'        {name}) words="{" ".join(sorted(all))}" ;;' for name, all in sorted(members.items())
    )
    valued = "|".join(
        sorted(
            {
                option["flag"]
                for option in table["options"] + sum((c["options"] for c in commands_of(table)), [])
                if option["value"]
            }
        )
    )
    return f"""# Completion of servodesk-cli for bash; made of its command table.
_servodesk_cli() {{
    local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}}
    local first="" second="" word words="" i
    case $previous in
    --port) mapfile -t COMPREPLY < <(compgen -W "{PORTS} $(echo /dev/ttyUSB* /dev/ttyACM*)" -- "$current") && return ;;
    --protocol) mapfile -t COMPREPLY < <(compgen -W "auto feetech modbus lx" -- "$current") && return ;;
    --lang) mapfile -t COMPREPLY < <(compgen -W "en zh_CN" -- "$current") && return ;;
    {valued}) mapfile -t COMPREPLY < <(compgen -f -- "$current") && return ;;
    esac
    for ((i = 1; i < COMP_CWORD; ++i)); do
        word=${{COMP_WORDS[i]}}
        case $word in
        {valued}) ((++i)) ;;
        -* | help) ;;
        *)
            if [ -z "$first" ]; then first=$word; elif [ -z "$second" ]; then second=$word; fi
            ;;
        esac
    done
    if [ -z "$first" ]; then
        words="{" ".join(first)}"
    elif [ -z "$second" ]; then
        case $first in
{groups}
        esac
    fi
    if [[ $current == -* ]]; then
        local options="{" ".join(option["flag"] for option in table["options"])} --help"
        for word in "$first $second" "$first"; do
            case $word in
{chr(10).join(cases)}
            esac
        done
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
    elif [ -n "$words" ]; then
        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
    else
        mapfile -t COMPREPLY < <(compgen -f -- "$current")
    fi
}}
complete -o filenames -F _servodesk_cli servodesk-cli
"""


def zsh_quote(text):
    return text.replace("'", "'\\''").replace("[", "(").replace("]", ")").replace(":", "\\:")


def zsh_completion(table):
    def specs(options):
        return [
            "'" + option["flag"] + "[" + zsh_quote(option["help"]) + "]"
            + (":" + zsh_quote(option["value"]) + ":_files" if option["value"] else "") + "'"
            for option in options
        ]

    names = "\n".join(
        f"        '{command['name'].split()[0]}:{zsh_quote(command['help'])}'" for command in commands_of(table)
        if " " not in command["name"]
    )
    groups = {}
    for command in commands_of(table):
        if " " in command["name"]:
            group, member = command["name"].split()
            groups.setdefault(group, []).append((member, command["help"]))
    group_names = "\n".join(f"        '{name}:commands of {name}'" for name in sorted(groups)
                            if name not in {c["name"] for c in commands_of(table)})
    member_cases = "\n".join(
        f"        {name}) members=(" + " ".join(f"'{member}:{zsh_quote(text)}'" for member, text in all) + ") ;;"
        for name, all in sorted(groups.items())
    )
    option_cases = "\n".join(
        f"        '{command['name']}') options=({' '.join(specs(command['options']))}) ;;"
        for command in commands_of(table) if command["options"]
    )
    common = " ".join(specs(table["options"]))
    return f"""#compdef servodesk-cli
# Completion of servodesk-cli for zsh; made of its command table.
_servodesk_cli() {{
    local -a commands members options common given
    local word
    commands=(
{names}
{group_names}
    )
    common=({common})
    given=()
    for word in ${{words[2,$((CURRENT - 1))]}}; do
        [[ $word == -* || $word == help ]] || given+=($word)
    done
    if [[ $words[CURRENT] == -* ]]; then
        case "${{given[1,2]}}" in
{option_cases}
        esac
        [[ ${{#options}} -gt 0 ]] || case "${{given[1]}}" in
{option_cases}
        esac
        _arguments $options $common
    elif (( ${{#given}} == 0 )); then
        _describe command commands
    else
        case $given[1] in
{member_cases}
        esac
        if (( ${{#members}} && ${{#given}} == 1 )); then
            _describe command members
        else
            _files
        fi
    fi
}}
_servodesk_cli "$@"
"""


def fish_quote(text):
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def fish_completion(table):
    lines = ["# Completion of servodesk-cli for fish; made of its command table."]
    every = "complete -c servodesk-cli"

    def option(condition, one):
        value = " -r" if one["value"] else ""
        return f"{every}{condition} -l {one['flag'][2:]}{value} -d {fish_quote(one['help'])}"

    lines += [option("", one) for one in table["options"]]
    lines.append(f"{every} -l port -x -a '{PORTS} (__fish_complete_suffix /dev/tty)'")
    first = sorted({command["name"].split()[0] for command in commands_of(table)})
    none_yet = " -n '__fish_use_subcommand' -f"
    plain = {command["name"]: command["help"] for command in commands_of(table) if " " not in command["name"]}
    for name in first:
        lines.append(f"{every}{none_yet} -a {name} -d {fish_quote(plain.get(name, 'commands of ' + name))}")
    for command in commands_of(table):
        words = command["name"].split()
        condition = f" -n '__fish_seen_subcommand_from {words[0]}"
        if len(words) == 2:
            lines.append(f"{every}{condition}' -a {words[1]} -d {fish_quote(command['help'])}")
            condition += f"; and __fish_seen_subcommand_from {words[1]}"
        lines += [option(condition + "'", one) for one in command["options"]]
    return "\n".join(lines) + "\n"


def main():
    programs, output = sys.argv[1:3]
    table = json.loads(run(os.path.join(programs, "servodesk-cli"), "--lang", "en", "help", "--json"))
    write(output, "man/servodesk-cli.1", man_page(table))
    for name, text in (
        ("servodesk", "set up and test serial bus servos"),
        ("servodesk-sim", "simulated bus of serial bus servos on a pseudo-terminal"),
    ):
        page = run("help2man", "--no-info", "--no-discard-stderr", f"--name={text}",
                   f"--version-string={table['version']}", os.path.join(programs, name))
        write(output, f"man/{name}.1", page)
    write(output, "bash/servodesk-cli", bash_completion(table))
    write(output, "zsh/_servodesk-cli", zsh_completion(table))
    write(output, "fish/servodesk-cli.fish", fish_completion(table))


main()
