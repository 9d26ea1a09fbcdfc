// Words that people use for those of the protocol: who has a channel, what a role does not permit.
import { t } from '../text/text';

const session = /session \d+ \(((?:[^()]|\([^()]*\))*)\)/;

/** Who a session belongs to: a user by name; else where it comes from. */
function personOf(peer: string): string {
  const [, user, process] = /^(?:(.*) \()?uid \d+, pid (\d+)\)?$/.exec(peer) ?? [];
  if (process === undefined) return peer;
  if (user === undefined) return t('who.program', { process });
  return /^uid \d+$/.test(user) ? t('who.link') : user;
}

/** Who is meant, whether a session is named or only where it comes from. */
export const whoIs = (name: string): string =>
  session.test(name) ? withPeople(name) : personOf(name);

/** A sentence of the daemon in which sessions are people. */
export const withPeople = (sentence: string): string =>
  sentence.replace(new RegExp(session, 'g'), (_, peer: string) => personOf(peer));

/** What a role may not do, without the name of the method. */
export function roleRefusal(sentence: string): string | null {
  const [, role] = /needs the role \w+; this session is (\w+)/.exec(sentence) ?? [];
  if (role === undefined) return null;
  return t('refusal.not_permitted', { role: t(`role.${role}` as 'role.observer') });
}
