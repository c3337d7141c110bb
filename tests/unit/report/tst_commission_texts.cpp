// SPDX-License-Identifier: GPL-3.0-or-later
// The reasons why a servo was not commissioned have a text in both languages.
#include "base/error.h"
#include "report/commission_text.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

using base::ErrorCode;

class TestCommissionTexts : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void errorsHaveText()
    {
        for (const ErrorCode code :
             {ErrorCode::NoReply, ErrorCode::Garbled, ErrorCode::UnexpectedReply,
              ErrorCode::LineBusy, ErrorCode::Refused, ErrorCode::Uncertain, ErrorCode::IdInUse,
              ErrorCode::DuplicateId, ErrorCode::FamilyConflict, ErrorCode::UnknownModel,
              ErrorCode::Mismatch, ErrorCode::LockOpen, ErrorCode::IdentityMismatch,
              ErrorCode::OutOfRange, ErrorCode::NotSupported}) {
            const QString word = base::errorName(code);
            const auto said = report::commissionIssueText({word, QStringLiteral("a|b")});
            QVERIFY2(!said.en.startsWith(word + QStringLiteral(" (")), qPrintable(word));
            QVERIFY2(said.zh != said.en, qPrintable(word));
        }
    }

    // The raw facts are only for the dialog that explains them.
    void familyFactsAreFormatted()
    {
        const auto said = report::commissionIssueText(
            {base::errorName(ErrorCode::FamilyConflict), QStringLiteral("3.25|STS/SCS2|1|9.3")});
        QVERIFY2(!said.en.contains(QLatin1Char('|')), qPrintable(said.en));
    }
};

SERVODESK_GUILESS_TEST(TestCommissionTexts)
#include "tst_commission_texts.moc"
