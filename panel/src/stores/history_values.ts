// How values of the history are shown: the unit once in the head of a column, digits by what it is.
import type { Column, ColumnName, Value } from '../rpc/history';
import { t } from '../text/text';
import { dateAndTime, duration, fixed } from './format';

// Parts of 1, shown in percent.
const shares: readonly ColumnName[] = ['availability', 'effectiveness', 'quality', 'oee', 'drift'];
const spans: readonly ColumnName[] = ['time_s', 'use_s', 'first_s', 'last_s'];

/** What stands behind the heading. */
export function columnUnit(name: ColumnName): string {
  if (shares.includes(name)) return ', %';
  return name === 'path_mm' ? `, ${t('unit.mm')}` : '';
}

export function shownValue(column: Column, value: Value): string {
  if (value === null) return '–';
  if (typeof value !== 'number') return String(value);
  if (column.kind === 'time') return dateAndTime(value);
  if (shares.includes(column.name)) return fixed(100 * value, 1);
  if (spans.includes(column.name)) return duration(value);
  return fixed(value, column.name === 'path_mm' ? 1 : 0);
}
