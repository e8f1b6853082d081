import { dictionary } from './i18n.ts';
import { droppedFiles } from './opening/given-files.ts';
import { openFiles } from './opening/open.ts';
import { dragOver } from './state.ts';

const holdsFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes('Files') ?? false;

/** Lets files and folders be dropped anywhere on the page. */
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
    void openFiles(droppedFiles(event.dataTransfer));
  });
}

export function DropTarget() {
  return dragOver.value ? <div class="drop-target">{dictionary.value.dropHere}</div> : null;
}
