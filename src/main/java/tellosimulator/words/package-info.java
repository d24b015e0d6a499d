/**
 * Words for people that can be said in several languages.
 *
 * <p>A {@link tellosimulator.words.Phrase} is made where something happens: an English template and
 * the values in it. Read as it is, it is English; a {@link tellosimulator.words.Translation} says
 * it otherwise. Everything is immutable and for any thread. The package imports nothing of the
 * project. What a drone sends on the wire is no phrase, and the other languages themselves are not
 * its job.
 */
package tellosimulator.words;
