// The program files beneath the program root of the daemon.
import { store } from './machine.svelte';
import type { Result } from '../rpc/json_rpc';

export type ProgramFile = Result<'program.list'>['programs'][number];

/** Programs by their ending; other files lie there, too. */
export const isProgram = (name: string): boolean => /\.(nc|ngc|mpf|spf|tap|txt|cnc)$/i.test(name);

class Programs {
  list = $state.raw<ProgramFile[]>([]);
  root = $state('');
  /** null while it is not known. */
  complete = $state<boolean | null>(null);

  async read(): Promise<void> {
    try {
      const { programs, root, complete } = await store.call('program.list');
      this.list = programs;
      this.root = root;
      this.complete = complete;
    } catch {
      this.complete = null;
    }
  }
}

export const programs = new Programs();
