# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Completion for fish. What may follow, palmer-cli itself says; where it says nothing, files are offered.
function __palmer_cli_follows
    set -l words (commandline -opc)
    palmer-cli --complete $words[2..] (commandline -ct) 2>/dev/null
end
complete -c palmer-cli -n 'test -n "$(__palmer_cli_follows)"' -f -k -a '(__palmer_cli_follows)'
