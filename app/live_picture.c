#include "live_picture.h"
void live_picture_init(struct live_picture *picture, const struct script *script, bool xray, const struct shader_folder *folder){ *picture=(struct live_picture){.script=script,.folder=folder,.xray=xray};}
void live_picture_finish(struct live_picture *picture, bool lost){(void)picture;(void)lost;}
bool live_picture_draw(struct live_picture *picture, struct display *display, const struct fields *fields, bool fresh, struct shader_error *error){(void)picture;(void)display;(void)fields;(void)fresh;(void)error;return true;}
void live_picture_reload(struct live_picture *picture, const struct shader_folder *folder){(void)picture;(void)folder;}
