// Namespaces of the companion specifications, and that of stanok.
import { nodesets } from 'node-opcua';

export const namespaces = {
  machine_tool: 'http://opcfoundation.org/UA/MachineTool/',
  machinery: 'http://opcfoundation.org/UA/Machinery/',
  stanok: 'urn:stanok:machines',
};

/** In the order of their dependence. */
export const nodeset_files = [
  nodesets.standard,
  nodesets.di,
  nodesets.isa95JobControl,
  nodesets.ia,
  nodesets.machinery,
  nodesets.machineryJobs,
  nodesets.machineTool,
];
