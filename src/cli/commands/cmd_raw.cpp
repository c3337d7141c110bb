// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/report_text.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "protocol/codec.h"

namespace cli {
namespace {
struct Piece {
    base::Bytes bytes;
    QString meaning;
};

/// Splits the received bytes into frames and noise.
std::vector<Piece> pieces(const protocol::Codec& codec, base::ByteView received)
{
    std::vector<Piece> found;
    while (!received.empty()) {
        const protocol::ScanResult result = codec.scan(received, {}, true);
        const std::size_t size = result.consumed > 0 ? result.consumed : received.size();
        const base::ByteView piece = received.first(size);
        const bool frame =
            result.kind == protocol::ScanKind::Reply || result.kind == protocol::ScanKind::Foreign;
        found.push_back(
            {base::Bytes(piece.begin(), piece.end()),
             frame ? codec.explain(piece, false) : translate("cli", "not a valid packet")});
        received = received.subspan(size);
    }
    return found;
}

/// By the bytes: two equal header bytes; Modbus has none.
base::Protocol protocolOf(base::ByteView sent)
{
    if (sent.size() < 2 || sent[0] != sent[1])
        return base::Protocol::Modbus;
    return sent[0] == 0x55 ? base::Protocol::Lx : base::Protocol::Feetech;
}

/// There is no reply to a broadcast.
bool expectsReply(base::Protocol language, base::ByteView sent)
{
    if (language == base::Protocol::Modbus)
        return sent[0] != 0;
    constexpr std::size_t idPlace = 2;
    return sent.size() <= idPlace || sent[idPlace] != protocol::broadcastId;
}

base::Result<Exit> runRaw(Run& run, const Values& values)
{
    const auto bytes = base::fromHex(values.arguments("HEX").join(QLatin1Char(' ')));
    if (!bytes || bytes->empty())
        return badArgument(translate("cli", "enter bytes as hexadecimal pairs: FF FF 01 02 01 FB"));
    const auto context = run.context();
    if (!context)
        return tl::unexpected(context.error());
    bus::Transaction transaction;
    const base::Protocol language = run.globals().protocol.value_or(protocolOf(*bytes));
    const protocol::Codec& codec = protocol::codecFor(language);
    transaction.request = protocol::Request::raw(*bytes).in(language);
    transaction.stop = &run.stop();
    const auto outcome = context->bus.transact(transaction);
    if (!outcome)
        return tl::unexpected(outcome.error());
    const base::Bytes received = outcome->replies.empty() ? base::Bytes() : outcome->data();
    const QString meaning = codec.explain(*bytes, true);
    Table table(
        {translate("cli", "Direction"), translate("cli", "Meaning"), translate("cli", "Bytes")});
    table.add({translate("cli", "sent"), meaning, base::toHex(*bytes)});
    Json::Array frames;
    for (const Piece& piece : pieces(codec, received)) {
        frames.push_back(
            Json::object().add("bytes", base::toHex(piece.bytes)).add("meaning", piece.meaning));
        table.add({translate("cli", "received"), piece.meaning, base::toHex(piece.bytes)});
    }
    run.finish(Json::object()
                   .add("sent", base::toHex(*bytes))
                   .add("meaning", meaning)
                   .add("received", base::toHex(received))
                   .add("frames", std::move(frames)),
               table.text());
    if (!received.empty() || !expectsReply(language, *bytes))
        return Exit::Success;
    run.console().printNote(translate("cli", "No reply."));
    return Exit::NoReply;
}
} // namespace

Command rawCommand()
{
    return {"raw",
            QT_TRANSLATE_NOOP("cli", "send raw bytes and show the reply"),
            {{"HEX", QT_TRANSLATE_NOOP("cli", "complete packet with checksum"), 1, many}},
            {},
            runRaw};
}
} // namespace cli
