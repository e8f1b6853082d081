// scratch: never committed
import { createServer } from 'vite';
const server = await createServer({ root: process.cwd(), configFile: false, logLevel: 'warn', appType: 'custom', server: { middlewareMode: true, ws: false, fs:{strict:false} }, optimizeDeps: { noDiscovery: true } });
const m = await server.ssrLoadModule(process.argv[2]);
await m.default(process.argv.slice(3));
process.exit(0);
