// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/conditionwords.h"

#include "tables/folded.h"
#include "tables/units.h"

#include <algorithm>
#include <array>
#include <string>

namespace palmer {

std::optional<Condition> conditionNamed(std::string_view label) {
    struct Words {
        Condition condition;
        std::string_view list; ///< folded, each between bars: English, French, German, Italian, Spanish
    };
    static constexpr std::array words{
        Words{Condition::machine, "|machine|machine name|machine tool|machine outil|maschine|"
                                  "werkzeugmaschine|macchina|maquina|"},
        Words{Condition::serialNumber,
              "|serial|serial no|serial number|s/n|sn|numero de serie|n° de serie|no de serie|seriennummer|"
              "serien-nr|matricola|numero di serie|nº de serie|"},
        Words{Condition::operatorName, "|operator|inspector|measured by|operateur|operatrice|controleur|"
                                       "bediener|prufer|pruefer|operatore|operador|"},
        Words{Condition::date, "|date|day|test date|date of test|jour|date de mesure|date d'essai|datum|tag|"
                               "messdatum|prufdatum|data|giorno|fecha|dia|"},
        Words{Condition::feed, "|feed|feedrate|feed rate|avance|vitesse d'avance|vorschub|"
                               "vorschubgeschwindigkeit|avanzamento|velocita di avanzamento|"
                               "velocidad de avance|"},
    };
    constexpr std::size_t longest = 60;
    std::string text = folded(withoutUnit(label.substr(0, longest)));
    text.erase(text.find_last_not_of(" .:=") + 1);
    if (text.empty() || text.find('|') != std::string::npos)
        return {};
    const auto *const found = std::ranges::find_if(
        words, [&](const Words &each) { return each.list.find('|' + text + '|') != std::string_view::npos; });
    return found == words.end() ? std::nullopt : std::optional(found->condition);
}

} // namespace palmer
