// The texts that the page speaks with now. They stay when those of another language do not come.
import { load, type Catalogue, type Language } from '../text/catalogue';

class Spoken {
  texts = $state.raw<Catalogue | null>(null);
  #wanted: Language | null = null;

  async speak(language: Language): Promise<void> {
    if (language === this.#wanted) return;
    this.#wanted = language;
    const texts = await load(language);
    if (language === this.#wanted) this.texts = texts;
  }
}

export const spoken = new Spoken();
