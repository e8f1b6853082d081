import { openSceneFiles } from './actions.ts';
import { dictionary } from './i18n.ts';
import { dragOver } from './state.ts';

const holdsFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes('Files') ?? false;

/** Lets a scene file be dropped anywhere on the page, with the files that it names. */
export function followDrops(): void {
  addEventListener('dragover', (event) => {
    if (!holdsFiles(event)) return;
    event.preventDefault();
    dragOver.value = true;
  });
  addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) dragOver.value = false;
  });
  addEventListener('drop', (event) => {
    if (!holdsFiles(event)) return;
    event.preventDefault();
    dragOver.value = false;
    void openSceneFiles([...(event.dataTransfer?.files ?? [])]);
  });
}

export function DropTarget() {
  return dragOver.value ? <div class="drop-target">{dictionary.value.dropHere}</div> : null;
}
