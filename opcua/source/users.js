// Users and their passwords: a line `NAME:scrypt:SALT:HASH` each, in base64. Scrypt (RFC 7914) with
// N = 2^15, r = 8, p = 1: 32 MiB and some 50 ms for each guess.
import { randomBytes, scrypt, scryptSync, timingSafeEqual } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { Usage } from './options.js';

const hash_bytes = 32;
const salt_bytes = 16;
const cost = { N: 2 ** 15, r: 8, p: 1, maxmem: 64 * 2 ** 20 };

/**
 * @import { User, Users } from '../types/view.js'
 */

/**
 * The line of a user. Throws Usage.
 * @param {string} name
 * @param {string} password
 */
export function user_line(name, password) {
  if (!/^[\w.@-]{1,64}$/.test(name))
    throw new Usage('--add-user needs a name of letters, digits, _, ., @ and -');
  if (password.length < 8) throw new Usage('a password must have 8 characters or more');
  const salt = randomBytes(salt_bytes);
  const hash = scryptSync(password, salt, hash_bytes, cost);
  return [name, 'scrypt', salt.toString('base64'), hash.toString('base64')].join(':');
}

/**
 * @param {string} line
 * @param {string} place
 * @returns {[string, User]}
 */
function user_from(line, place) {
  const [name, kind, salt, hash, ...more] = line.split(':');
  const user = { salt: Buffer.from(salt ?? '', 'base64'), hash: Buffer.from(hash ?? '', 'base64') };
  if (kind !== 'scrypt' || more.length > 0 || user.hash.length !== hash_bytes)
    throw new Error(`${place}: this is not a line of stanok-opcua --add-user`);
  return [name, user];
}

/**
 * Users of a file by their names. Throws Error with the place of a wrong line.
 * @param {string} file
 * @returns {Users}
 */
export function users_from(file) {
  const lines = readFileSync(file, 'utf8').split('\n');
  const users = lines.map((line, k) => (line ? [user_from(line, `${file}:${k + 1}`)] : []));
  return new Map(users.flat());
}

/**
 * Whether it is the password; takes as long for a name that nobody has.
 * @param {Users} users
 * @param {string} name
 * @param {string} password
 * @returns {Promise<boolean>}
 */
export function is_password(users, name, password) {
  const nobody = { salt: Buffer.alloc(salt_bytes), hash: Buffer.alloc(hash_bytes) };
  const user = users.get(name) ?? nobody;
  return new Promise((resolve) => {
    scrypt(password, user.salt, hash_bytes, cost, (error, hash) => {
      resolve(!error && user !== nobody && timingSafeEqual(hash, user.hash));
    });
  });
}
