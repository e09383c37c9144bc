// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/storedsentence.h"

#include <QStringList>
#include <deque>

namespace palmer {

namespace {

constexpr QChar parted(0x1E);
constexpr QChar inner(0x1F);

QString clean(const char *text) {
    QString result = QString::fromUtf8(text);
    return result.remove(parted).remove(inner);
}

QString clean(const std::string &text) {
    return clean(text.c_str());
}

QString stored(const Argument &argument) {
    if (const auto *number = std::get_if<Number>(&argument))
        return QStringLiteral("n") + QString::number(number->value, 'g', 17) + inner +
               QString::number(static_cast<int>(number->quantity)) + inner +
               QString::number(number->decimals);
    if (const auto *text = std::get_if<Text>(&argument))
        return QStringLiteral("t") + clean(text->source) + inner + clean(text->comment);
    if (const auto *date = std::get_if<Date>(&argument))
        return QStringLiteral("d") + clean(date->iso);
    if (const auto *standard = std::get_if<Designation>(&argument))
        return QStringLiteral("e") + clean(standard->word);
    return QStringLiteral("s") + clean(std::get<std::string>(argument));
}

/// Owns texts known only at run time while their sentence is built.
class Texts {
public:
    Text text(const QString &source, const QString &comment) {
        m_kept.push_back(source.toStdString());
        const char *const first = m_kept.back().c_str();
        m_kept.push_back(comment.toStdString());
        return {first, m_kept.back().c_str()};
    }

private:
    std::deque<std::string> m_kept;
};

Argument argumentFrom(const QString &stored, Texts &texts) {
    const QStringList parts = stored.mid(1).split(inner);
    switch (stored.isEmpty() ? '\0' : stored.front().toLatin1()) {
    case 'n':
        return Number{parts.value(0).toDouble(), static_cast<Quantity>(parts.value(1).toInt()),
                      parts.value(2).toInt()};
    case 't':
        return texts.text(parts.value(0), parts.value(1));
    case 'd':
        return Date{parts.value(0).toStdString()};
    case 'e':
        return Designation{parts.value(0).toStdString()};
    default:
        return parts.value(0).toStdString();
    }
}

} // namespace

QString storedSentence(const Error &error) {
    QStringList fields{clean(error.place), clean(error.message.text.source),
                       clean(error.message.text.comment),
                       error.message.count ? QString::number(*error.message.count) : QString()};
    for (const Argument &argument : error.message.arguments)
        fields << stored(argument);
    return fields.join(parted);
}

QString sentenceFrom(const QString &stored, const Language &language) {
    constexpr qsizetype head = 4;
    const QStringList fields = stored.split(parted);
    if (fields.size() < head)
        return stored;
    Texts texts;
    Message message{texts.text(fields[1], fields[2])};
    if (!fields[3].isEmpty())
        message.count = fields[3].toInt();
    for (qsizetype i = head; i < fields.size(); ++i)
        message.arguments.push_back(argumentFrom(fields[i], texts));
    const QString sentence = language.sentence(message);
    return fields[0].isEmpty() ? sentence : fields[0] + QStringLiteral(": ") + sentence;
}

} // namespace palmer
