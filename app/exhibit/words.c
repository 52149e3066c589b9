#include "words.h"

#include <stddef.h>
#include <string.h>

#include "exhibit_read.h"

const struct words_language words_languages[WORDS_LANGUAGES] = {
    {"en", "English", false}, {"fr", "Français", false}, {"ar", "العربية", true},   {"ja", "日本語", false},
    {"de", "Deutsch", false}, {"es", "Español", false},  {"it", "Italiano", false}, {"zh", "中文", false},
};

enum { SHIPPED = 4 };

/* French has a narrow space that does not break (U+202F) before ! and before a unit. Seconds are abbreviated: English
 * and French then need no plural, and Arabic none of its four. */
static const char *const TEXTS_SHIPPED[TEXTS][SHIPPED] = {
    [TEXT_INVITE] = {"Touch the paper", "Touchez le papier", "المسوا الورقة", "紙に触れてみてください"},
    [TEXT_INKS] = {"Inks", "Encres", "الأحبار", "インク"},
    [TEXT_DROP] = {"Drop", "Goutte", "قطرة", "しずく"},
    [TEXT_BRUSH] = {"Brush", "Pinceau", "فرشاة", "筆"},
    [TEXT_GUIDE] = {"Guide", "Guider", "توجيه", "導く"},
    [TEXT_POUR] = {"Pour", "Verser", "سكب", "注ぐ"},
    [TEXT_MASK] = {"Keep clear", "Laisser libre", "مساحة خالية", "余白を残す"},
    [TEXT_REWIND] = {"Turn back time", "Remonter le temps", "العودة بالزمن", "時を戻す"},
    [TEXT_PLANT] = {"Plant", "Planter", "زرع", "植える"},
    [TEXT_TEND] = {"Tend", "Cultiver", "رعاية", "育てる"},
    [TEXT_THIN] = {"Thin out", "Éclaircir", "تخفيف", "間引く"},
    [TEXT_STRIKE] = {"Lightning", "Foudre", "صاعقة", "稲妻"},
    [TEXT_REPEL] = {"Repel", "Repousser", "تنافر", "遠ざける"},
    [TEXT_STROKE] = {"Charged line", "Trait chargé", "خط مشحون", "電気の線"},
    [TEXT_DOSE] = {"Dose", "Doser", "جرعة", "たらす"},
    [TEXT_ERASE] = {"Erase", "Effacer", "محو", "消す"},
    [TEXT_MAP] = {"Map", "Carte", "خريطة", "地図"},
    [TEXT_PICTURE] = {"Next picture", "Autre image", "الصورة التالية", "次の絵"},
    [TEXT_METAPHOR] = {"Another kind", "Autre espèce", "نوع آخر", "別の種類"},
    [TEXT_UNDO] = {"Undo", "Annuler", "تراجع", "元に戻す"},
    [TEXT_REDO] = {"Redo", "Rétablir", "إعادة", "やり直す"},
    [TEXT_FINISH] = {"Finished", "Terminé", "انتهيت", "できあがり"},
    [TEXT_HAND] = {"Other hand", "Autre main", "اليد الأخرى", "反対の手"},
    [TEXT_SEATED] = {"Within reach", "À portée de main", "في متناول اليد", "手の届く範囲"},
    [TEXT_COUNTDOWN] = {"The paper will be washed in {seconds} s", "Le papier sera lavé dans {seconds}\u202fs",
                        "ستُغسل الورقة بعد {seconds} ث", "あと{seconds}秒で紙を洗います"},
    [TEXT_STAY] = {"Touch the paper to go on", "Touchez le papier pour continuer", "المسوا الورقة للمتابعة",
                   "続けるには紙に触れてください"},
    [TEXT_THANKS] = {"Thank you for painting with us", "Merci d’avoir peint avec nous\u202f!", "شكرًا لأنكم رسمتم معنا",
                     "描いてくださり、ありがとうございました"},
    [TEXT_CLOSED] = {"We are closing now. See you soon!", "Nous fermons. À bientôt\u202f!", "نغلق الآن. إلى اللقاء",
                     "ただいま終了しました。またのお越しをお待ちしております"},
};

int words_find(const char *tag)
{
    for (int i = 0; i < WORDS_LANGUAGES && words_languages[i].tag; i++) {
        if (strcmp(words_languages[i].tag, tag) == 0) {
            return i;
        }
    }
    return -1;
}

const char *words_key(enum exhibit_text text)
{
    return text_keys[text].name;
}

const char *words_shipped(enum exhibit_text text, int language)
{
    if (text == TEXT_LANGUAGE) {
        return words_languages[language].name;
    }
    return language < SHIPPED ? TEXTS_SHIPPED[text][language] : NULL;
}

const char *words_of(const struct words texts[TEXTS], enum exhibit_text text, int language)
{
    const char *own = texts[text].in[language], *shipped = words_shipped(text, language);
    if (own || shipped) {
        return own ? own : shipped;
    }
    own = texts[text].in[0];
    return own ? own : words_shipped(text, 0);
}
