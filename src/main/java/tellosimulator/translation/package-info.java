/**
 * The languages of the program besides English.
 *
 * <p>A {@link tellosimulator.translation.PhraseCatalog} is a {@link
 * tellosimulator.words.Translation} that is read from a glossary in the same package. All types are
 * immutable. The package imports {@code words}. The texts of the window and of reports are in the
 * packages that show them.
 */
package tellosimulator.translation;
