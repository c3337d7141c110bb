#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the manual pages of the three programs, from what they say of themselves: servodesk-cli by its command
table (help --json), the others by --help through help2man.

Usage: generate-docs.py FOLDER_OF_THE_PROGRAMS OUTPUT_FOLDER"""
import json
import os
import subprocess
import sys

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


def main():
    programs, output = sys.argv[1:3]
    table = json.loads(run(os.path.join(programs, "servodesk-cli"), "--lang", "en", "help", "--json"))
    write(output, "servodesk-cli.1", man_page(table))
    for name, text in (
        ("servodesk", "set up and test serial bus servos"),
        ("servodesk-sim", "simulated bus of serial bus servos on a pseudo-terminal"),
    ):
        page = run("help2man", "--locale=C.UTF-8", "--no-info", "--no-discard-stderr", f"--name={text}",
                   f"--version-string={table['version']}", os.path.join(programs, name))
        write(output, f"{name}.1", page)


main()
