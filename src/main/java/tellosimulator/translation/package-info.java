/**
 * The languages that the program speaks besides English.
 *
 * <p>A {@link tellosimulator.translation.PhraseCatalog} is a {@link
 * tellosimulator.words.Translation} that is read from a glossary beside it. Everything is immutable
 * and for any thread. The package imports {@code words}. Texts of the window and of reports are not
 * its job: they are beside what shows them.
 */
package tellosimulator.translation;
