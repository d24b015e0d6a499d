/**
 * The scenarios that somebody can choose from: cards of those that come with the program, and the
 * files that were open last.
 *
 * <p>{@link tellosimulator.view.gallery.GalleryPane} shows them. {@link
 * tellosimulator.view.gallery.RoomPictures} draws the pictures of the cards on a thread of its own
 * and keeps them; {@link tellosimulator.view.gallery.RecentFiles} remembers files. Everything else
 * is for the JavaFX thread. Opening what was chosen is not its job.
 */
package tellosimulator.view.gallery;
