// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/commission_text.h"

#include "report/bilingual.h"

#include <array>

namespace report {
namespace {
using record::CommissionIssue;
using record::CommissionVerdict;

struct IssueText {
    const char* word;
    const char* english; ///< %1: the detail
    const char* chinese;
};
constexpr std::array issueTexts{
    IssueText{"not-writable", "what %1 is, is not known: nothing is written",
              "%1 的参数表未知，不写入"},
    IssueText{"no-such-rate", "it cannot run %1 baud", "不支持波特率 %1"},
    IssueText{"no-such-id", "it cannot have ID %1", "不支持 ID %1"},
    IssueText{"no-centring", "%1 servos have no centring command", "%1 系列无校中指令"},
    IssueText{"other-model", "the template is of another model: %1", "模板来自其他型号：%1"},
    IssueText{"rows-left", "rows of the template left alone: %1", "模板中未写入的项：%1"},
    IssueText{"other-id", "it does not have the factory's ID, but %1", "不是出厂 ID，而是 %1"},
    IssueText{"no-id-left", "no ID is left for it", "ID 已用完"},
    IssueText{"already-done", "it is done already", "此舵机已设置完成"},
    IssueText{"by-hand", "set aside by hand", "手动剔除"},
    IssueText{"label-not-kept", "its label could not be kept in the history (%1)",
              "标签未能写入历史记录（%1）"},
    IssueText{"rate-after-restart", "%1 baud acts after a restart only", "波特率 %1 重启后生效"},
    IssueText{"rate-differs", "its register says %1 baud", "寄存器中的波特率为 %1"},
    IssueText{"torque-was-on", "torque was on; it has been switched off", "扭矩输出曾打开，已关闭"},
    IssueText{"row-mismatch", "%1 reads back differently", "%1 回读不一致"},
    IssueText{"row-refused", "%1 was refused", "%1 写入被拒绝"},
    IssueText{"row-not-sent", "%1 was not sent", "%1 未发送"},
    IssueText{"row-no-answer", "no answer while %1 was written", "写入 %1 时通信超时"},
    IssueText{"row-unknown", "what became of %1 is not known", "%1 的写入结果未知"},
    IssueText{"no-answer", "it did not answer", "通信超时"},
    IssueText{"garbled", "its answers were broken", "应答数据错误"},
    IssueText{"id-in-use", "the ID is in use: two servos are on the wire",
              "ID 被占用：总线上有两个舵机"},
    IssueText{"several-servos", "two servos answer under this ID", "此 ID 下有两个舵机应答"},
    IssueText{"family-unclear", "its family is unclear: nothing is written", "系列不明确，不写入"},
    IssueText{"unknown-model", "its firmware is not known: nothing is written", "固件未知，不写入"},
    IssueText{"mismatch", "%1 does not hold the value of the template", "%1 与模板的数值不一致"},
    IssueText{"wrong-answer", "its answers did not fit the questions", "应答与请求不符"},
    IssueText{"line-busy", "the line never fell silent", "总线上数据不断"},
    IssueText{"refused", "it did not take what was written", "写入未生效"},
    IssueText{"lock-open", "its EPROM lock could not be proven closed", "无法确认 EPROM 已上锁"},
    IssueText{"identity-differs", "another servo answers now: %1", "应答的是其他舵机：%1"},
    IssueText{"out-of-range", "the value is out of its range: %1", "数值超出范围：%1"},
    IssueText{"not-supported", "not supported: %1", "不支持：%1"},
    IssueText{"unfinished-id", "the unfinished servo has ID %1", "未完成的舵机 ID 为 %1"},
    IssueText{"unfinished-ids", "the unfinished servo may have any of these IDs: %1",
              "未完成的舵机可能使用以下任一 ID：%1"},
    IssueText{"unfinished-lock", "its EPROM lock was opened and has not been proven closed",
              "其 EPROM 已解锁，无法确认已重新上锁"},
    IssueText{"uncertain", "what became of a write is not known", "写入结果未知"},
};

struct AlarmText {
    const char* key;
    const char* english;
    const char* chinese;
};
constexpr std::array alarmTexts{
    AlarmText{"voltage", "voltage alarm", "过压欠压"},
    AlarmText{"temperature", "temperature alarm", "过温"},
    AlarmText{"overload", "overload alarm", "过载"},
    AlarmText{"current", "overcurrent alarm", "过流"},
    AlarmText{"sensor", "sensor alarm", "传感器故障"},
};

Text filled(const char* english, const char* chinese, const QString& detail)
{
    Text text = both(english, chinese);
    for (QString* half : {&text.en, &text.zh}) {
        if (half->contains(QLatin1String("%1")))
            *half = half->arg(detail);
    }
    return text;
}

struct VerdictText {
    CommissionVerdict verdict;
    const char* english;
    const char* chinese;
    const char* sign;
};
constexpr std::array verdictTexts{
    VerdictText{CommissionVerdict::Good, "Good", "合格", "✔"},
    VerdictText{CommissionVerdict::Remark, "Done, see remarks", "完成，有备注", "▲"},
    VerdictText{CommissionVerdict::Failed, "Failed", "失败", "✖"},
    VerdictText{CommissionVerdict::Skipped, "Set aside", "未设置", "–"},
};

const VerdictText& wordsOf(CommissionVerdict verdict)
{
    for (const VerdictText& known : verdictTexts) {
        if (known.verdict == verdict)
            return known;
    }
    return verdictTexts.front();
}
} // namespace

Text commissionIssueText(const CommissionIssue& issue)
{
    if (issue.word == QLatin1String("alarm")) {
        for (const AlarmText& known : alarmTexts) {
            if (issue.detail == QLatin1String(known.key))
                return both(known.english, known.chinese);
        }
        return filled("alarm: %1", "报警：%1", issue.detail);
    }
    for (const IssueText& known : issueTexts) {
        if (issue.word == QLatin1String(known.word))
            return filled(known.english, known.chinese, issue.detail);
    }
    const QString plain = issue.detail.isEmpty()
                              ? issue.word
                              : QStringLiteral("%1 (%2)").arg(issue.word, issue.detail);
    return {plain, plain};
}

Text commissionIssuesText(const std::vector<CommissionIssue>& issues)
{
    QStringList english;
    QStringList chinese;
    for (const CommissionIssue& issue : issues) {
        const Text words = commissionIssueText(issue);
        english.append(words.en);
        chinese.append(words.zh);
    }
    return {english.join(QStringLiteral("; ")), chinese.join(QStringLiteral("；"))};
}

Text commissionVerdictText(CommissionVerdict verdict)
{
    const VerdictText& words = wordsOf(verdict);
    return both(words.english, words.chinese);
}

QString commissionVerdictSign(CommissionVerdict verdict)
{
    return QString::fromUtf8(wordsOf(verdict).sign);
}
} // namespace report
