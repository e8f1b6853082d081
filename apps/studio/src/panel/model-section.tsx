import type { ImportReport } from 'mirrorball';
import { frameView } from '../actions.ts';
import { Button } from '../controls/button.tsx';
import { Menu } from '../controls/menu.tsx';
import { Switch } from '../controls/switch.tsx';
import { dictionary } from '../i18n.ts';
import {
  chooseCamera,
  chooseClip,
  chooseVariant,
  chosenCamera,
  chosenVariant,
  hasGround,
  showGround,
} from '../model.ts';
import { type Shown, shown } from '../state.ts';
import { Section } from './section.tsx';

/** Of a file that was opened: what it has, what can be chosen, and what was not taken as it stands. */
export function ModelSection() {
  const t = dictionary.value;
  const now = shown.value;
  if (now?.id !== 'file') return null;
  return (
    <Section id="model" title={t.model}>
      <Facts shown={now} />
      <Choices shown={now} />
      <Button id="frame" icon="frame" onClick={frameView}>
        {t.frame}
      </Button>
      <Switch id="ground" label={t.ground} checked={hasGround.value} onChange={showGround} />
      {now.report && now.report.entries.length > 0 && <Report report={now.report} />}
    </Section>
  );
}

/** Megabytes, or of small things kilobytes. */
const amount = (bytes: number): string =>
  bytes < 1e5 ? `${Math.ceil(bytes / 1e3)} kB` : `${(bytes / 1e6).toFixed(bytes < 1e7 ? 1 : 0)} MB`;

function Facts({ shown: { fileName, report, bytes = 0 } }: { shown: Shown }) {
  const t = dictionary.value;
  const { triangles = 0, materials = 0, images = 0 } = report?.counts ?? {};
  const facts: readonly (readonly [string, string])[] = [
    [t.factFile, fileName ?? ''],
    [t.factTriangles, t.count(triangles)],
    [t.factMaterials, t.count(materials)],
    [t.factTextures, t.count(images)],
    [t.factMemory, amount(bytes)],
  ];
  return (
    <dl id="model-facts" class="facts">
      {facts.map(([name, value]) => (
        <div key={name}>
          <dt>{name}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}

function Choices({ shown: { original, scene } }: { shown: Shown }) {
  const t = dictionary.value;
  const named = (things: object | undefined) => Object.keys(things ?? {}).map((name) => ({ value: `=${name}`, label: name })); // biome-ignore format: short
  const [cameras, clips, variants] = [named(original.cameras), named(original.clips), named(original.variants)];
  const first = (label: string) => ({ value: '', label });
  const keyOf = (name: string | null | undefined) => (name == null ? '' : `=${name}`);
  const nameOf = (key: string) => (key === '' ? null : key.slice(1));
  return (
    <>
      {cameras.length > 0 && (
        <Menu
          id="model-camera"
          label={t.camera}
          options={[first(t.cameraFramed), ...cameras]}
          value={keyOf(chosenCamera.value)}
          onChange={(key) => chooseCamera(nameOf(key))}
        />
      )}
      {clips.length > 0 && (
        <Menu
          id="model-clip"
          label={t.clip}
          options={[first(t.clipNone), ...clips]}
          value={keyOf(scene.clip)}
          onChange={(key) => chooseClip(nameOf(key))}
        />
      )}
      {variants.length > 0 && (
        <Menu
          id="model-variant"
          label={t.variant}
          options={[first(t.variantOwn), ...variants]}
          value={keyOf(chosenVariant.value)}
          onChange={(key) => chooseVariant(nameOf(key))}
        />
      )}
    </>
  );
}

function Report({ report }: { report: ImportReport }) {
  const t = dictionary.value;
  return (
    <details id="import-report" class="report">
      <summary>{t.report(report.entries.length)}</summary>
      <ul>
        {report.entries.map((entry) => (
          <li key={`${entry.kind} ${entry.what} ${entry.message}`}>
            <strong>{t.reportKinds[entry.kind]}</strong> {entry.what !== 'file' && <code>{entry.what}</code>}
            <p>{t.reportEntry(entry)}</p>
          </li>
        ))}
      </ul>
    </details>
  );
}
