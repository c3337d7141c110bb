// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/history_server_dialog.h"

#include "history/server/server_address.h"
#include "session/history/history_server_choice.h"
#include "text/error_text.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {
namespace {
constexpr int initialWidth = 520;
}

HistoryServerDialog::HistoryServerDialog(session::Settings& settings,
                                         session::HistorySender& sender, QWidget* parent)
    : QDialog(parent)
    , m_settings(settings)
    , m_sender(sender)
    , m_explanation(new QLabel(this))
    , m_addressName(new QLabel(this))
    , m_address(new QLineEdit(this))
    , m_benchName(new QLabel(this))
    , m_bench(new QLineEdit(this))
    , m_hint(new QLabel(this))
    , m_errorLabel(new QLabel(this))
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this))
{
    setObjectName(QStringLiteral("historyServerDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    const session::HistoryServerChoice now = session::historyServerChoice(settings);
    m_address->setObjectName(QStringLiteral("serverAddress"));
    m_address->setText(history::ServerAddress::masked(now.address));
    m_address->setEnabled(!now.isFixedByEnvironment);
    m_bench->setObjectName(QStringLiteral("serverBench"));
    m_bench->setText(now.bench);
    m_addressName->setBuddy(m_address);
    m_benchName->setBuddy(m_bench);
    m_buttons->button(QDialogButtonBox::Save)->setObjectName(QStringLiteral("serverSave"));
    makeMainAction(m_buttons->button(QDialogButtonBox::Save));
    m_buttons->button(QDialogButtonBox::Cancel)->setObjectName(QStringLiteral("serverCancel"));
    auto* column = new QVBoxLayout(this);
    m_errorLabel->setObjectName(QStringLiteral("serverRefusal"));
    for (QLabel* description : {m_explanation, m_hint, m_errorLabel}) {
        description->setWordWrap(true);
        description->setTextFormat(Qt::PlainText);
    }
    m_errorLabel->setTextInteractionFlags(Qt::TextSelectableByMouse);
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_explanation, m_addressName, m_address, m_errorLabel,
                                         m_benchName, m_bench, m_hint, m_buttons})
        column->addWidget(widget);
    connect(m_address, &QLineEdit::textEdited, this, [this] { setError(std::nullopt); });
    connect(m_buttons, &QDialogButtonBox::accepted, this, &HistoryServerDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    resize(initialWidth, height());
    followLanguage(this, [this] { retranslate(); });
    resize(initialWidth, layout()->totalHeightForWidth(initialWidth));
}

void HistoryServerDialog::accept()
{
    session::HistoryServerChoice choice{m_address->text().trimmed(), m_bench->text().trimmed()};
    choice.isFixedByEnvironment = !m_address->isEnabled();
    if (const auto kept = session::setHistoryServerChoice(m_settings, choice); !kept) {
        setError(kept.error());
        m_address->setFocus();
        return;
    }
    const session::HistoryServerChoice now = session::historyServerChoice(m_settings);
    m_sender.setServer(now.address, now.bench);
    m_sender.tryNow();
    QDialog::accept();
}

/// Beside the field, until it is edited.
void HistoryServerDialog::setError(std::optional<base::Error> error)
{
    m_error = std::move(error);
    m_errorLabel->setVisible(m_error.has_value());
    m_errorLabel->clear();
    if (m_error) {
        const text::Description description = text::describe(*m_error);
        m_errorLabel->setText(
            QStringLiteral("✗ ") +
            QStringList{description.message, description.cause, description.remedy}.join(u'\n'));
    }
    m_errorLabel->setAccessibleName(m_errorLabel->text());
    layout()->activate();
    resize(width(), layout()->totalHeightForWidth(width()));
}

void HistoryServerDialog::retranslate()
{
    setWindowTitle(tr("History server"));
    setAccessibleName(windowTitle());
    m_explanation->setText(
        tr("Writes, snapshots, labels and tests from this bench are copied to a PostgreSQL server, "
           "where all benches can be viewed together. This computer keeps its own complete "
           "history; an unreachable server never blocks a write."));
    m_addressName->setText(tr("&Server"));
    m_address->setAccessibleName(tr("Server"));
    m_address->setPlaceholderText(QStringLiteral("postgresql://user@host/servodesk"));
    m_address->setToolTip(
        tr("PostgreSQL connection string; leave empty to keep the history on this computer only"));
    m_benchName->setText(tr("&Name of this bench"));
    m_bench->setAccessibleName(tr("Name of this bench"));
    m_bench->setToolTip(
        tr("Name under which other benches find this bench's history on the server"));
    setError(m_error);
    m_hint->setText(
        m_address->isEnabled()
            ? tr("Store the password in ~/.pgpass, not in the connection string. A server on "
                 "another computer must use TLS with a valid certificate; to change that, add "
                 "?sslmode=… to the connection string.")
            : tr("The server is set by the environment variable SERVODESK_HISTORY_SERVER."));
    QPushButton* save = m_buttons->button(QDialogButtonBox::Save);
    save->setText(tr("Save"));
    save->setAccessibleName(save->text());
    save->setToolTip(tr("Saves the settings and starts sending"));
    QPushButton* cancel = m_buttons->button(QDialogButtonBox::Cancel);
    cancel->setText(tr("Cancel"));
    cancel->setAccessibleName(cancel->text());
    cancel->setToolTip(tr("Discards the changes"));
}
} // namespace ui
