// The views, each loaded when it is wanted; the machine view comes with the page.
import type { Component } from 'svelte';
import type { View } from '../stores/route.svelte';
import MachineView from './machine/MachineView.svelte';

const loaders: Record<View, () => Promise<{ default: Component }>> = {
  machine: () => Promise.resolve({ default: MachineView }),
  cell: () => import('./cell/CellView.svelte'),
  path: () => import('./path/PathView.svelte'),
  programs: () => import('./programs/ProgramsView.svelte'),
  tools: () => import('./tools/ToolsView.svelte'),
  drives: () => import('./drives/DrivesView.svelte'),
  scope: () => import('./scope/ScopeView.svelte'),
  process: () => import('./process/ProcessView.svelte'),
  history: () => import('./history/HistoryView.svelte'),
  help: () => import('./help/HelpView.svelte'),
};

export async function loadView(view: View): Promise<Component> {
  return (await loaders[view]()).default;
}
