package tellosimulator.fault;

import tellosimulator.words.Phrase;

/** A fault that cannot be: misspelt, out of range, or of something that it does not have. */
public final class FaultTextException extends IllegalArgumentException {

  private static final long serialVersionUID = 1;

  private final transient Phrase phrase;

  public FaultTextException(Phrase phrase) {
    super(phrase.english());
    this.phrase = phrase;
  }

  /** What is wrong, in any language. */
  public Phrase phrase() {
    return phrase;
  }
}
