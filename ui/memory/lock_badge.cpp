// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/memory/lock_badge.h"

#include "ui/common/theme.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QStyle>
#include <QToolButton>

namespace ui {
namespace {
LockBadge::Lock lockOf(const session::ServoEntry* entry)
{
    using Lock = LockBadge::Lock;
    if (entry == nullptr || !entry->servo.profile)
        return Lock::NoServo;
    if (entry->servo.profile->byRole(catalog::Role::Lock) == nullptr)
        return Lock::None;
    const auto open = entry->isLockOpen();
    if (!open)
        return Lock::NotRead;
    if (!*open)
        return Lock::Closed;
    return entry->lockOpenedByUs || entry->writing() ? Lock::OpenByUs : Lock::OpenByOthers;
}

Tone toneOf(LockBadge::Lock lock)
{
    switch (lock) {
    case LockBadge::Lock::Closed:
        return Tone::Good;
    case LockBadge::Lock::OpenByUs:
        return Tone::Warn;
    case LockBadge::Lock::OpenByOthers:
        return Tone::Bad;
    case LockBadge::Lock::NoServo:
    case LockBadge::Lock::None:
    case LockBadge::Lock::NotRead:
        break;
    }
    return Tone::Quiet;
}
} // namespace

LockBadge::LockBadge(QAction* closeLock, QWidget* parent)
    : QWidget(parent)
    , m_sign(new QLabel(this))
    , m_word(new QLabel(this))
    , m_close(new QToolButton(this))
{
    setObjectName(QStringLiteral("lockBadge"));
    m_word->setObjectName(QStringLiteral("lockWord"));
    m_close->setObjectName(QStringLiteral("closeLock"));
    m_close->setDefaultAction(closeLock);
    m_close->setToolButtonStyle(Qt::ToolButtonTextOnly);
    QSizePolicy policy = m_close->sizePolicy();
    policy.setRetainSizeWhenHidden(true); // every write opens and closes the lock
    m_close->setSizePolicy(policy);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 0, 4, 0);
    layout->setSpacing(4);
    layout->addWidget(m_sign);
    layout->addWidget(m_word);
    layout->addWidget(m_close);
    retranslate();
}

QString LockBadge::lockText(Lock lock)
{
    switch (lock) {
    case Lock::None:
        return tr("no EPROM lock");
    case Lock::NotRead:
        return tr("EPROM lock not read");
    case Lock::Closed:
        return tr("EPROM locked");
    case Lock::OpenByUs:
        return tr("EPROM unlocked");
    case Lock::OpenByOthers:
        return tr("EPROM left unlocked");
    case Lock::NoServo:
        break;
    }
    return {};
}

void LockBadge::setEntry(const session::ServoEntry* entry)
{
    const Lock lock = lockOf(entry);
    if (lock == m_lock)
        return;
    m_lock = lock;
    retranslate();
}

void LockBadge::retranslate()
{
    QString tip;
    switch (m_lock) {
    case Lock::NoServo:
        break;
    case Lock::None:
        tip = tr("This family has no EPROM lock. The servo stores every setting immediately.");
        break;
    case Lock::NotRead:
        tip = tr("The EPROM lock has not been read. Choose Read all.");
        break;
    case Lock::Closed:
        tip = tr("The EPROM is locked. ServoDesk unlocks it for a write and locks it again "
                 "afterwards.");
        break;
    case Lock::OpenByUs:
        tip = tr("ServoDesk unlocked the EPROM for a write that has not finished. If no write "
                 "is in progress, open Port → Interrupted writes.");
        break;
    case Lock::OpenByOthers:
        tip = tr("Another program left the EPROM unlocked, so values written by any program are "
                 "kept after power-off. Lock the EPROM when you have finished with that program.");
        break;
    }
    m_word->setText(lockText(m_lock));
    int widest = 0; // the row must not wrap differently when the text changes
    for (const Lock lock :
         {Lock::None, Lock::NotRead, Lock::Closed, Lock::OpenByUs, Lock::OpenByOthers})
        widest = std::max(widest, m_word->fontMetrics().horizontalAdvance(lockText(lock)));
    m_word->setMinimumWidth(widest);
    setVisible(m_lock != Lock::NoServo);
    setToolTip(tip);
    setAccessibleName(m_word->text());
    setAccessibleDescription(tip);
    m_close->setText(tr("Lock"));
    m_close->setAccessibleName(tr("Lock the EPROM"));
    m_close->setVisible(m_lock == Lock::OpenByUs || m_lock == Lock::OpenByOthers);
    showSign();
}

void LockBadge::showSign()
{
    const bool open = m_lock == Lock::OpenByUs || m_lock == Lock::OpenByOthers;
    const bool has = open || m_lock == Lock::Closed;
    const int size = style()->pixelMetric(QStyle::PM_SmallIconSize, nullptr, this);
    const QIcon icon = QIcon::fromTheme(open ? QStringLiteral("object-unlocked")
                                             : QStringLiteral("object-locked"));
    m_sign->setPixmap(has ? icon.pixmap(size, size) : QPixmap());
    QPalette colors;
    colors.setColor(QPalette::WindowText, tone(toneOf(m_lock), palette()));
    if (m_word->palette().color(QPalette::WindowText) != colors.color(QPalette::WindowText))
        m_word->setPalette(colors);
}

void LockBadge::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange)
        showSign();
}
} // namespace ui
