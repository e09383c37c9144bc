#compdef palmer-cli
# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Completion for zsh. What may follow, palmer-cli itself says; where it says nothing, files are offered.
local line
local -a found meanings
for line in ${(f)"$(palmer-cli --complete "${(@)words[2,CURRENT]}" 2>/dev/null)"}; do
    found+=("${line%%$'\t'*}")
    meanings+=("${line%%$'\t'*}  ${line#*$'\t'}")
done
if (($#found)); then
    if [[ $found[1] == *= ]]; then
        compadd -S '' -l -d meanings -a found
    else
        compadd -l -d meanings -a found
    fi
else
    _files
fi
