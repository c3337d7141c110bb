// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/servo_strip.h"

#include "ui/common/follow_language.h"
#include "ui/operate/servo_card.h"
#include "ui/widgets/feedback.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QScrollBar>

#include <algorithm>

namespace ui {
using session::ServoRef;

ServoStrip::ServoStrip(const session::ServoRegistry& registry, const session::LinkController& link,
                       Selection& selection, QWidget* parent)
    : QScrollArea(parent)
    , m_registry(registry)
    , m_link(link)
    , m_selection(selection)
    , m_body(new QWidget(this))
    , m_row(new QHBoxLayout(m_body))
{
    setObjectName(QStringLiteral("servoStrip"));
    setFrameShape(NoFrame);
    setWidgetResizable(true);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_row->setContentsMargins({});
    m_row->setSpacing(6);
    m_row->addStretch();
    setWidget(m_body);
    connect(&registry, &session::ServoRegistry::servoAdded, this, &ServoStrip::rebuild);
    connect(&registry, &session::ServoRegistry::servoRemoved, this, &ServoStrip::rebuild);
    connect(&registry, &session::ServoRegistry::servosCleared, this, &ServoStrip::rebuild);
    connect(&registry, &session::ServoRegistry::orderChanged, this, &ServoStrip::rebuild);
    connect(&selection, &Selection::selectedServosChanged, this, &ServoStrip::refresh);
    hide(); // of less than two there is nothing to choose from
    rebuild();
    followLanguage(this, [this] {
        setAccessibleName(tr("All servos"));
        refresh();
    });
}

void ServoStrip::rebuild()
{
    const std::vector<ServoRef>& servos = m_registry.order();
    const auto same = [](const auto& card, ServoRef ref) { return card.first == ref; };
    if (std::equal(m_cards.begin(), m_cards.end(), servos.begin(), servos.end(), same))
        return refresh();
    for (const auto& [ref, card] : m_cards) {
        card->hide(); // it may be painted once more before it is gone
        card->deleteLater();
    }
    m_cards.clear();
    for (const ServoRef ref : servos) {
        auto* card = new ServoCard(m_body);
        card->setObjectName(QStringLiteral("servoCard"));
        connect(card, &QAbstractButton::clicked, this, [this, ref] { selectServo(ref); });
        m_row->insertWidget(m_row->count() - 1, card);
        m_cards.emplace_back(ref, card);
    }
    setVisible(m_cards.size() > 1);
    if (!m_cards.empty())
        setFixedHeight(m_cards.front().second->sizeHint().height() +
                       horizontalScrollBar()->sizeHint().height() + 2);
    refresh();
}

void ServoStrip::selectServo(ServoRef ref)
{
    if (!QApplication::keyboardModifiers().testFlag(Qt::ControlModifier)) {
        m_selection.select(ref);
        return;
    }
    std::vector<ServoRef> chosen = m_selection.selected();
    const auto place = std::find(chosen.begin(), chosen.end(), ref);
    if (place == chosen.end())
        chosen.push_back(ref);
    else if (chosen.size() > 1)
        chosen.erase(place);
    m_selection.setSelected(chosen);
}

void ServoStrip::refresh()
{
    const std::vector<ServoRef>& chosen = m_selection.selected();
    for (const auto& [ref, card] : m_cards) {
        if (const session::ServoEntry* entry = m_registry.servo(ref))
            card->show(
                cardState(*entry, isFresh(*entry, m_link, m_registry.now()), m_registry.now()),
                std::find(chosen.begin(), chosen.end(), ref) != chosen.end());
    }
}
} // namespace ui
