// SPDX-License-Identifier: Apache-2.0
//
// node read_with_mcap_core.js PACKAGES RECORDING OUTPUT: reads a recording with the package @mcap/core, installed in the
// folder PACKAGES, and writes what it read as JSON {messages: [{topic, schema, time, data}], statistics}.
const { readFileSync, writeFileSync } = require("node:fs");
const { createRequire } = require("node:module");
const { McapStreamReader } = createRequire(`${process.argv[2]}/package.json`)("@mcap/core");

const reader = new McapStreamReader({ validateCrcs: true });
reader.append(readFileSync(process.argv[3]));
const schemas = new Map(), channels = new Map(), read = { messages: [], complete: false };
for (let record; (record = reader.nextRecord()); ) {
  if (record.type === "Schema") schemas.set(record.id, record);
  if (record.type === "Channel") channels.set(record.id, record);
  if (record.type === "Statistics") read.statistics = Number(record.messageCount);
  if (record.type === "Footer") read.complete = true;
  if (record.type !== "Message") continue;
  const channel = channels.get(record.channelId), schema = schemas.get(channel.schemaId);
  JSON.parse(new TextDecoder().decode(schema.data));
  read.messages.push({
    topic: channel.topic,
    encoding: channel.messageEncoding,
    schema: schema.name,
    time: Number(record.logTime),
    data: JSON.parse(new TextDecoder().decode(record.data)),
  });
}
writeFileSync(process.argv[4], JSON.stringify(read));
