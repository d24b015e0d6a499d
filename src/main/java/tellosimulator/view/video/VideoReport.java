package tellosimulator.view.video;

import tellosimulator.words.Phrase;

/**
 * What became of a picture or a film that a person wanted to keep.
 *
 * @param drone its number, from 1
 * @param good whether it is kept
 */
public record VideoReport(int drone, boolean good, Phrase phrase) {}
