// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/register_location.h"

#include <algorithm>
#include <map>

namespace catalog {
namespace {
constexpr int feetechTableBytes = 256;
constexpr int modbusRegisterBytes = 2; // of one register
constexpr int lxParameterBytes = 8;    // bytes of the table an LX command owns
constexpr int maxLxParameters = 4;     // parameters of the longest command of the sheet
constexpr int lxCommandCount = tableBytes / lxParameterBytes;

int requiredInteger(JsonFields& fields, const char* name, int min, int max)
{
    fields.require(name);
    return static_cast<int>(fields.integer(name, min, max).value_or(min));
}

void readFeetechLocation(JsonFields& fields, Register& reg)
{
    reg.address = requiredInteger(fields, "address", 0, feetechTableBytes - 1);
    if (reg.address + reg.size > feetechTableBytes)
        fields.addError(QStringLiteral("the register reaches beyond address 255"));
    reg.offset = reg.writeOffset = reg.address;
}

void readModbusLocation(JsonFields& fields, Register& reg)
{
    reg.address = requiredInteger(fields, "address", 0, tableBytes / modbusRegisterBytes - 1);
    if (reg.size != modbusRegisterBytes)
        fields.addError(QStringLiteral("\"size\" of a Modbus register must be 2"));
    reg.offset = reg.writeOffset = modbusRegisterBytes * reg.address;
}

void readLxLocation(JsonFields& fields, Register& reg)
{
    reg.address = requiredInteger(fields, "address", 1, lxCommandCount - 1);
    const int position = requiredInteger(fields, "place", 1, maxLxParameters);
    if (position + reg.size - 1 > maxLxParameters)
        fields.addError(QStringLiteral("the register reaches beyond the parameters"));
    const auto write = fields.integer("write", 1, lxCommandCount - 1);
    const auto save = fields.integer("save", 1, lxCommandCount - 1);
    reg.offset = lxParameterBytes * reg.address + position - 1;
    reg.writeOffset =
        write ? lxParameterBytes * static_cast<int>(*write) + position - 1 : reg.offset;
    reg.saveOffset = save ? lxParameterBytes * static_cast<int>(*save) : -1;
    if (save && !write)
        fields.addError(QStringLiteral("\"save\" needs \"write\""));
}

template <typename Visit>
void forEachDefinition(MapDef& map, Visit visit)
{
    for (RegisterRow& row : map.rows) {
        visit(row.base.reg);
        for (auto& [condition, def] : row.set)
            visit(def.reg);
    }
}
} // namespace

void readLocation(JsonFields& fields, Register& reg, base::Protocol protocol)
{
    reg.size = requiredInteger(fields, "size", 1, 4);
    if (reg.size == 3)
        fields.addError(QStringLiteral("\"size\" must be 1, 2 or 4"));
    switch (protocol) {
    case base::Protocol::Feetech:
        return readFeetechLocation(fields, reg);
    case base::Protocol::Modbus:
        return readModbusLocation(fields, reg);
    case base::Protocol::Lx:
        return readLxLocation(fields, reg);
    }
}

void assignBlocks(MapDef& map)
{
    if (map.protocol != base::Protocol::Lx)
        return;
    std::map<int, Block> blocks; // by read command
    forEachDefinition(map, [&](Register& reg) {
        Block& block = blocks[reg.address];
        const int first = lxParameterBytes * reg.address;
        block.offset = first;
        block.size = std::max(block.size, reg.offset + reg.size - first);
        if (reg.writable())
            block.writeOffset = reg.writeOffset - (reg.offset - first);
        else if (block.writeOffset == 0)
            block.writeOffset = first;
    });
    forEachDefinition(map, [&](Register& reg) { reg.block = blocks[reg.address]; });
}
} // namespace catalog
