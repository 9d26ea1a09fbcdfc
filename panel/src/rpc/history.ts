// Questions to the history of the gateway, which the server of the page reads.
import { sessionFields } from './session';

export const questions = ['runs', 'alarms', 'oee', 'tools', 'drift'] as const;
export const times = ['8h', '1d', '7d', '30d', '365d'] as const;

/** As the server names them. */
export type ColumnName =
  | 'ended'
  | 'machine'
  | 'channel'
  | 'program'
  | 'version'
  | 'time_s'
  | 'path_mm'
  | 'blocks'
  | 'ok'
  | 'time'
  | 'code'
  | 'text'
  | 'file'
  | 'line'
  | 'runs'
  | 'availability'
  | 'effectiveness'
  | 'quality'
  | 'oee'
  | 'tool'
  | 'use_s'
  | 'last'
  | 'first_s'
  | 'last_s'
  | 'drift';

export interface Column {
  name: ColumnName;
  kind: 'text' | 'number' | 'time' | 'yes_no';
}
export type Value = string | number | boolean | null;

export interface History {
  columns: Column[];
  rows: Value[][];
}

export interface Question {
  query: (typeof questions)[number];
  since: string;
  /** Empty: all. */
  machine: string;
}

const patience_ms = 20_000;

/** Throws an Error with the sentence of the server. */
export async function readHistory(question: Question): Promise<History> {
  const answer = await fetch('/api/history', {
    method: 'POST',
    headers: { 'content-type': 'application/json', ...sessionFields() },
    body: JSON.stringify(question),
    signal: AbortSignal.timeout(patience_ms),
  });
  const content = (await answer.json()) as History & { error?: string };
  if (!answer.ok) throw new Error(content.error ?? String(answer.status));
  return content;
}
