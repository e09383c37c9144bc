# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Completion for bash. What may follow, palmer-cli itself says; where it says nothing, files are offered.
_palmer_cli()
{
    local words=() word joins=
    for word in "${COMP_WORDS[@]:1:COMP_CWORD}"; do # bash parts words at = and :
        if [[ -n $joins || $word == [=:] ]] && ((${#words[@]})); then
            words[-1]+=$word
        else
            words+=("$word")
        fi
        [[ $word == [=:] ]] && joins=yes || joins=
    done
    local current=${words[-1]} parted=${COMP_WORDS[COMP_CWORD]} IFS=$'\n'
    [[ $parted == [=:] ]] && parted=
    local before=${current%"$parted"}
    COMPREPLY=($(palmer-cli --complete "${words[@]}" 2>/dev/null | cut -f1))
    COMPREPLY=("${COMPREPLY[@]#"$before"}")
    [[ ${COMPREPLY[0]-} == *= ]] && compopt -o nospace
    return 0
}
complete -o default -F _palmer_cli palmer-cli
