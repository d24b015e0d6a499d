package tellosimulator.fault;

import tellosimulator.words.Phrase;

/**
 * Thrown if the text of a fault is misspelt, contains a value out of range, or contains a parameter
 * that faults of its kind do not have.
 */
public final class FaultTextException extends IllegalArgumentException {

  private static final long serialVersionUID = 1;

  private final transient Phrase phrase;

  public FaultTextException(Phrase phrase) {
    super(phrase.english());
    this.phrase = phrase;
  }

  /** Returns the message as a translatable phrase. */
  public Phrase phrase() {
    return phrase;
  }
}
