/**
 * The gallery: cards of the scenarios that come with the program, and the recently opened files.
 *
 * <p>{@link tellosimulator.view.gallery.GalleryPane} lays out both. {@link
 * tellosimulator.view.gallery.RoomPictures} draws the pictures of the cards on a separate thread
 * and caches them; {@link tellosimulator.view.gallery.RecentFiles} stores the paths of the files.
 * Everything else is confined to the JavaFX thread. The package does not open the chosen scenario
 * itself.
 */
package tellosimulator.view.gallery;
